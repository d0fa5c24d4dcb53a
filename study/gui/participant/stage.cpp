#include "study/gui/participant/stage.h"

#include <algorithm>

#include <QBoxLayout>
#include <QEvent>
#include <QPainter>
#include <QPainterPath>

#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

// [px] at scale 1
constexpr int kColumn = 360;      // width of the words beside the panel
constexpr int kBesidePanel = 28;  // between the panel and the words
constexpr int kLeastColumn = 240;
constexpr int kLeastPanel = 320;  // width
constexpr int kLowPage = 380;     // height of a page that has no room for a card
constexpr int kRound = 14;        // radius of the panel's corners

/// Paints the corners of a panel in the page's colour, over whatever the panel shows.
class RoundCorners final : public QWidget {
 public:
  explicit RoundCorners(QWidget* panel) : QWidget(panel) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    panel->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Resize || event->type() == QEvent::StyleChange) cover();
    if (event->type() == QEvent::ChildAdded) raise();
    return QWidget::eventFilter(watched, event);
  }

  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath outside;
    outside.addRect(rect());
    QPainterPath panel;
    const int r = scaled(*this, kRound);
    panel.addRoundedRect(rect(), r, r);
    painter.fillPath(outside.subtracted(panel), themeOf(*this).window.background);
  }

 private:
  /// Only the corners lie over the panel, so that nothing else is painted twice.
  void cover() {
    setGeometry(parentWidget()->rect());
    const int r = scaled(*this, kRound);
    QRegion corners(rect());
    corners -= QRegion(rect().adjusted(r, 0, -r, 0));
    corners -= QRegion(rect().adjusted(0, r, 0, -r));
    setMask(corners);
    raise();
  }
};

}  // namespace

Stage::Stage(const QString& title, QWidget* shown, Panel panel, QWidget* parent)
    : QWidget(parent),
      kind_(panel),
      grid_(new QGridLayout(this)),
      panel_(shown),
      scroll_(new QScrollArea(this)),
      title_(titleLabel(title, nullptr)),
      foot_(new QWidget(this)),
      reason_(bodyLabel({}, foot_)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  auto* inside = new QWidget(scroll_);
  column_ = withoutMargins<QGridLayout>(inside);
  column_->setColumnStretch(0, 1);
  title_->setParent(inside);
  body_ = new QWidget(inside);
  words_ = withoutMargins<QVBoxLayout>(body_, scaled(*this, 12));
  stopHint_ = quietLabel(tr("To pause or stop: let go, and tell the researcher."), inside);
  scroll_->setWidgetResizable(true);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setWidget(inside);
  footRows_ = withoutMargins<QGridLayout>(foot_, scaled(*this, 10));
  footRows_->setColumnStretch(0, 1);
  buttons_ = new QBoxLayout(QBoxLayout::LeftToRight);
  buttons_->setSpacing(scaled(*this, 10));
  reason_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  if (panel_ != nullptr) panel_->setParent(this);
  if (panel_ != nullptr && kind_ == Panel::Picture) new RoundCorners(panel_);
  place(false);
}

void Stage::setCaption(const QString& caption) {
  if (panel_ == nullptr || kind_ != Panel::Card) return;
  auto* card = static_cast<QBoxLayout*>(panel_->layout());
  auto* words = bodyLabel(caption, panel_);
  words->setProperty("role", QStringLiteral("key"));
  words->setAlignment(Qt::AlignHCenter);
  constexpr int kPictureShare = 3;  // shares of the height
  card->setStretch(0, kPictureShare);
  card->insertStretch(0, 1);
  card->addWidget(words);
  card->addStretch(1);
}

void Stage::setCounter(QWidget* counter) {
  counter_ = counter;
  counter_->setParent(scroll_->widget());
  place(isWide_);
}

void Stage::addButton(QPushButton* button) {
  button->setProperty("role", QStringLiteral("next"));
  buttons_->addWidget(button);
}

void Stage::setReason(const QString& reason) {
  reason_->setText(reason);
  reason_->setVisible(!reason.isEmpty());
}

int Stage::heightOfWords(int width) const {
  const auto* words = scroll_->widget()->layout();
  return words->hasHeightForWidth() ? words->heightForWidth(width) : words->sizeHint().height();
}

/// Puts the panel beside the words and the foot, or between them.
void Stage::place(bool isWide) {
  isWide_ = isWide;
  for (QWidget* each : {static_cast<QWidget*>(panel_), static_cast<QWidget*>(scroll_), foot_}) {
    if (each != nullptr) grid_->removeWidget(each);
  }
  for (auto* each :
       {static_cast<QWidget*>(title_), body_, counter_, static_cast<QWidget*>(stopHint_)}) {
    if (each != nullptr) column_->removeWidget(each);
  }
  footRows_->removeWidget(reason_);
  footRows_->removeItem(buttons_);
  grid_->setVerticalSpacing(scaled(*this, 12));
  column_->setVerticalSpacing(scaled(*this, 20));
  const bool isPanelBetween = panel_ != nullptr && !panel_->isHidden() && !isWide;
  title_->ensurePolished();
  const bool isCounterBesideTitle = isPanelBetween && counter_ != nullptr &&
                                    title_->fontMetrics().horizontalAdvance(title_->text()) +
                                            scaled(*this, kBesidePanel) +
                                            counter_->sizeHint().width() <=
                                        width();
  column_->addWidget(title_, 0, 0);
  column_->addWidget(body_, 1, 0, 1, isCounterBesideTitle ? 2 : 1);
  if (counter_ != nullptr) {
    isCounterBesideTitle ? column_->addWidget(counter_, 0, 1, Qt::AlignRight | Qt::AlignVCenter)
                         : column_->addWidget(counter_, 2, 0);
  }
  column_->addWidget(stopHint_, 3, 0);
  column_->setRowStretch(4, 1);
  if (isWide) {
    grid_->addWidget(panel_, 0, 0, 2, 1);
    grid_->addWidget(scroll_, 0, 1);
    grid_->addWidget(foot_, 1, 1);
    footRows_->addWidget(reason_, 0, 0);
    footRows_->addLayout(buttons_, 1, 0, Qt::AlignRight);
  } else {
    grid_->addWidget(scroll_, 0, 0);
    if (panel_ != nullptr) grid_->addWidget(panel_, 1, 0);
    grid_->addWidget(foot_, 2, 0);
    footRows_->addWidget(reason_, 0, 0);
    footRows_->addLayout(buttons_, 0, 1, Qt::AlignRight);
  }
  buttons_->setDirection(isWide ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  grid_->setColumnStretch(0, 1);
  grid_->setColumnStretch(1, 0);
  grid_->setRowStretch(0, isWide || !isPanelBetween ? 1 : 0);
  grid_->setRowStretch(1, isPanelBetween ? 1 : 0);
  grid_->setHorizontalSpacing(isWide ? scaled(*this, kBesidePanel) : 0);
}

void Stage::arrange() {
  const bool hasPanel =
      panel_ != nullptr && (kind_ == Panel::Picture || height() >= scaled(*this, kLowPage));
  const int between = scaled(*this, kBesidePanel);
  const int column = std::clamp(
      width() - between - scaled(*this, kLeastPanel),
      scaled(*this, kLeastColumn),
      scaled(*this, kColumn));
  // A panel that would be much higher than wide is better off between the words and the foot.
  constexpr double kLeastAspect = 0.75;
  const bool isWide = hasPanel && width() - between - column >= kLeastAspect * height();
  if (panel_ != nullptr) panel_->setVisible(hasPanel);
  place(isWide);
  if (isWide) {
    scroll_->setFixedWidth(column);
    scroll_->setMinimumHeight(0);
    scroll_->setMaximumHeight(QWIDGETSIZE_MAX);
    foot_->setFixedWidth(column);
    return;
  }
  for (QWidget* each : {static_cast<QWidget*>(scroll_), foot_}) {
    each->setMinimumWidth(0);
    each->setMaximumWidth(QWIDGETSIZE_MAX);
  }
  if (hasPanel) {
    scroll_->setFixedHeight(std::min(heightOfWords(width()), height() / 2));
  } else {
    scroll_->setMinimumHeight(0);
    scroll_->setMaximumHeight(QWIDGETSIZE_MAX);
  }
}

void Stage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

bool Stage::event(QEvent* event) {
  // The scale, or the words, may have changed.
  if (event->type() == QEvent::StyleChange) arrange();
  if (event->type() == QEvent::LayoutRequest && !isWide_ && panel_ != nullptr &&
      !panel_->isHidden()) {
    scroll_->setFixedHeight(std::min(heightOfWords(width()), height() / 2));
  }
  return QWidget::event(event);
}

}  // namespace study::gui
