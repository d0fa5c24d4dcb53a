#include "study/gui/desk/work_dialog.h"

#include <algorithm>
#include <vector>

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QResizeEvent>
#include <QScreen>
#include <QTimer>

#include "study/gui/widgets/field_row.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/written_file.h"

namespace study::gui {
namespace {

constexpr int kUsualWidth = 760;        // [px]
constexpr double kShareOfScreen = 0.9;  // the rest is for the desktop's bars

/// Collects the widgets of a layout that the Tab key reaches, in the order in which they are shown.
void collectTabStops(const QLayout& layout, std::vector<QWidget*>& stops) {
  for (int i = 0; i < layout.count(); ++i) {
    auto* item = layout.itemAt(i);
    if (item->layout() != nullptr) collectTabStops(*item->layout(), stops);
    auto* widget = item->widget();
    if (widget == nullptr) continue;
    // A field of several parts, such as a path with its button, is moved as a whole.
    if (widget->focusProxy() != nullptr || (widget->focusPolicy() & Qt::TabFocus) != 0) {
      stops.push_back(widget);
    } else if (widget->layout() != nullptr) {
      collectTabStops(*widget->layout(), stops);
    }
  }
}

}  // namespace

WorkDialog::WorkDialog(
    const QString& title, const QString& what, const QString& verb, QWidget* parent)
    : QDialog(parent),
      scroll_(new QScrollArea(this)),
      form_(new FieldForm),
      notice_(bodyLabel({}, this)),
      outcomeLine_(bodyLabel({}, this)),
      writtenFile_(new WrittenFile(this)),
      details_(new NoteList(this)),
      disabledReason_(quietLabel({}, this)),
      runButton_(new QPushButton(verb, this)) {
  setWindowTitle(title);
  auto* heading = headingLabel(title, this);
  runButton_->setProperty("role", QStringLiteral("main"));
  runButton_->setObjectName(QStringLiteral("go"));
  runButton_->setDefault(true);
  notice_->setObjectName(QStringLiteral("notice"));
  notice_->setVisible(false);
  outcomeLine_->setObjectName(QStringLiteral("outcome"));
  details_->setObjectName(QStringLiteral("more"));
  details_->setAccessibleName(tr("Details"));
  form_->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form_->setVerticalSpacing(10);
  auto* inside = new QWidget(this);
  auto* page = withMargins<QVBoxLayout>(inside, {24, 20, 24, 0}, 14);
  page->addWidget(heading);
  page->addWidget(quietLabel(what, this));
  page->addWidget(notice_);
  page->addLayout(form_);
  page->addWidget(outcomeLine_);
  page->addWidget(writtenFile_);
  page->addWidget(details_);
  page->addStretch(1);
  scroll_->setWidgetResizable(true);
  scroll_->setWidget(inside);
  scroll_->setFocusPolicy(Qt::NoFocus);  // it scrolls to what has the focus
  auto* layout = withoutMargins<QVBoxLayout>(this, 14);
  layout->addWidget(scroll_, 1);
  layout->addLayout(makeButtons());
  resize(kUsualWidth, 0);
  clear();
}

void WorkDialog::addBeside(QBoxLayout* pictures) {
  auto* page = qobject_cast<QVBoxLayout*>(scroll_->widget()->layout());
  const int place = page->indexOf(form_);
  page->takeAt(place);
  body_ = new QHBoxLayout;
  body_->setSpacing(24);
  auto* left = new QVBoxLayout;
  left->addLayout(form_);
  left->addStretch(1);
  constexpr int kFormStretch = 3;  // of seven parts of the width
  constexpr int kPicturesStretch = 4;
  body_->addLayout(left, kFormStretch);
  body_->addLayout(pictures, kPicturesStretch);
  pictures_ = pictures;
  page->insertLayout(place, body_, 1);
}

void WorkDialog::addResult(ResultView* result) {
  auto* page = qobject_cast<QVBoxLayout*>(scroll_->widget()->layout());
  page->insertWidget(page->indexOf(details_), result);
  result_ = result;
  connect(
      result, &ResultView::tableChanged, this, [this] { fitTable(scroll_->viewport()->height()); });
}

QHBoxLayout* WorkDialog::makeButtons() {
  auto* close = new QPushButton(tr("Close"), this);
  close->setAutoDefault(false);
  auto* buttons = withMargins<QHBoxLayout>(nullptr, {24, 0, 24, 20});
  disabledReason_->setObjectName(QStringLiteral("obstacle"));
  disabledReason_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  disabledReason_->setWordWrap(false);
  buttons->addWidget(disabledReason_, 1);
  buttons->addWidget(close);
  buttons->addWidget(runButton_);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(runButton_, &QPushButton::clicked, this, [this] { work(); });
  return buttons;
}

void WorkDialog::setDisabledReason(const QString& obstacle) {
  runButton_->setEnabled(obstacle.isEmpty());
  disabledReason_->setText(obstacle);
}

void WorkDialog::addReason(
    const QString& label, const std::function<void()>& changed, const QString& hint) {
  reason_ = new QLineEdit(this);
  reason_->setObjectName(QStringLiteral("reason"));
  reason_->setPlaceholderText(hint);
  form_->addRow(label, reason_);
  connect(reason_, &QLineEdit::textChanged, this, changed);
}

std::string WorkDialog::reason() const {
  return reason_->isVisibleTo(this) ? reason_->text().trimmed().toStdString() : std::string();
}

QLabel* WorkDialog::addHint(const QString& words) {
  auto* hint = quietLabel(words, this);
  hint->setSizePolicy(QSizePolicy::Expanding, hint->sizePolicy().verticalPolicy());
  form_->addRow(QString(), hint);
  return hint;
}

void WorkDialog::showNotice(Mark mark, const QString& line) {
  showMarked(*notice_, mark, line);
  notice_->setVisible(!line.isEmpty());
}

void WorkDialog::showOutcome(Outcome outcome, const QString& line, const std::vector<Note>& more) {
  showMarked(*outcomeLine_, outcome, line);
  outcomeLine_->setVisible(true);
  writtenFile_->show(QString());
  if (outcome == Outcome::Good) setMain(false);
  showDetails(more);
}

void WorkDialog::showWrittenFile(
    const QString& path, const QString& line, const std::vector<Note>& more, Outcome outcome) {
  showOutcome(outcome, line, more);
  writtenFile_->show(path);
  disabledReason_->clear();  // that another file is to be chosen first would look like a failure
  fit();
  scroll_->ensureWidgetVisible(outcomeLine_);  // otherwise the form above it may fill the screen
}

void WorkDialog::showDetails(const std::vector<Note>& more) {
  details_->show(more);
  details_->setVisible(!more.empty());
  fit();
  QTimer::singleShot(0, this, &WorkDialog::fit);  // new labels get the theme only afterwards
}

void WorkDialog::setMain(bool isMain) {
  // A button that erases data keeps the role "danger".
  const bool isDanger = runButton_->property("role").toString() == QStringLiteral("danger");
  if (!isDanger) setRole(*runButton_, isMain ? "main" : "");
}

/// Tab goes through the fields in the order of the rows and ends at the buttons. The first field
/// has the focus; without one, the button.
void WorkDialog::orderTabStops() {
  std::vector<QWidget*> fields;
  collectTabStops(*form_, fields);
  std::vector<QWidget*> stops;
  collectTabStops(*scroll_->widget()->layout(), stops);
  collectTabStops(*layout(), stops);
  for (std::size_t i = 1; i < stops.size(); ++i) setTabOrder(stops[i - 1], stops[i]);
  const auto first = std::ranges::find_if(fields, [this](const QWidget* field) {
    return field->isVisibleTo(this) && field->isEnabled();
  });
  (first == fields.end() ? runButton_ : *first)->setFocus();
}

/// The height of the page without scrolling. A scrolled widget is never lower than its minimum size
/// hint, for which labels wrap into more lines.
int WorkDialog::heightOfPage() const {
  auto* inside = scroll_->widget();
  inside->layout()->activate();
  return std::max(
      inside->layout()->totalHeightForWidth(width()), inside->minimumSizeHint().height());
}

/// Gives the table the part of the height @p room [px] that the rest of the page does not need.
void WorkDialog::fitTable(int room) {
  if (result_ == nullptr || result_->isHidden()) return;
  result_->giveTableRoom(room - (heightOfPage() - result_->tableHeight()));
}

/// The height for which nothing is scrolled, as far as the screen has room.
int WorkDialog::wantedHeight() {
  constexpr int kFocusFrame = 6;  // [px] that a button grows by while it has the focus
  const auto* buttons = layout()->itemAt(1);
  const int below = layout()->spacing() + buttons->sizeHint().height() + kFocusFrame;
  const int most = static_cast<int>(kShareOfScreen * screen()->availableSize().height());
  fitTable(most - below);
  return std::min(heightOfPage() + below, most);
}

void WorkDialog::fit() {
  const bool isOwn = !isVisible() || height() == fittedHeight_;
  const int wanted = wantedHeight();
  fitTo(isOwn ? wanted : std::max(wanted, height()));
}

void WorkDialog::fitTo(int height) {
  fittedHeight_ = height;
  // A scroll bar narrows the labels; they then wrap into more lines and keep the bar necessary.
  scroll_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  resize(width(), height);
  scroll_->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  fitTable(scroll_->viewport()->height());
  keepOnScreen();
}

/// Moves a dialog back that has grown over an edge of the screen.
void WorkDialog::keepOnScreen() {
  if (!isVisible()) return;
  const QRect room = screen()->availableGeometry();
  const QRect frame = frameGeometry();
  const auto inside = [](int place, int length, int from, int to) {
    return std::max(from, std::min(place, to - length + 1));
  };
  const QPoint place(
      inside(frame.left(), frame.width(), room.left(), room.right()),
      inside(frame.top(), frame.height(), room.top(), room.bottom()));
  if (place != frame.topLeft()) move(place);
}

void WorkDialog::widen(int width) {
  const auto most = static_cast<int>(kShareOfScreen * screen()->availableSize().width());
  resize(std::max(this->width(), std::min(width, most)), height());
}

void WorkDialog::resizeEvent(QResizeEvent* event) {
  constexpr int kWideEnough = 1000;  // [px] for a form and a picture
  if (pictures_ != nullptr) {
    const bool isWide = event->size().width() >= kWideEnough;
    body_->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    pictures_->setDirection(isWide ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  }
  QDialog::resizeEvent(event);
  fitTable(scroll_->viewport()->height());
}

void WorkDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  for (auto* choice : findChildren<QComboBox*>()) {
    // Long entries do not make the field wider than the dialog.
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  auto numbers = findChildren<QAbstractSpinBox*>();
  numbers.removeIf([](const QAbstractSpinBox* number) {  // those beside others share the width
    return number->minimumWidth() > 0 || qobject_cast<FieldRow*>(number->parentWidget()) != nullptr;
  });
  int widest = 0;
  for (const auto* number : numbers) widest = std::max(widest, number->sizeHint().width());
  for (auto* number : numbers) number->setMinimumWidth(widest);
  orderTabStops();
  fit();  // sizes depend on the theme, which is applied when the dialog is shown
  QTimer::singleShot(0, this, &WorkDialog::fit);  // some fields get the theme only afterwards
}

void WorkDialog::clear() {
  outcomeLine_->clear();
  outcomeLine_->setVisible(false);
  writtenFile_->show(QString());
  setMain(true);
  showDetails({});
}

}  // namespace study::gui
