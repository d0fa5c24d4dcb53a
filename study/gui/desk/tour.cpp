#include "study/gui/desk/tour.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QImage>
#include <QPainter>
#include <QScreen>
#include <QShowEvent>
#include <QVBoxLayout>

#include "protocols/load_protocol.h"
#include "study/gui/operator/live_plot.h"
#include "study/gui/operator/travel_plot.h"
#include "study/gui/participant/questionnaire_page.h"
#include "study/gui/participant/trial_page.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/simulation_view.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/fitting_scroll.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/mnemonics.h"
#include "study/gui/widgets/read_only_table.h"
#include "study/gui/widgets/studio_settings.h"

namespace study::gui {
namespace {

constexpr const char* kTourSeenKey = "tour-seen";
constexpr const char* kTourProtocol = "punch-face-validity";
constexpr int kTourPictureInterval = 33;  // [ms]
constexpr int kTourSteps = 3;

protocols::LoadedProtocol shippedPunchProtocol() {
  questionnaires::Problems problems;
  auto loaded = protocols::loadProtocolFile(kTourProtocol, problems);
  if (!loaded) throw std::logic_error("a protocol that ships is not sound");
  return std::move(*loaded);
}

/// A picture from the program's resources, scaled to the available space.
class FittedPicture final : public QWidget {
 public:
  FittedPicture(const QString& name, const QString& resource, QWidget* parent)
      : QWidget(parent), picture_(resource) {
    setAccessibleName(name);
    setMinimumHeight(kLeastHeight);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
  }

  int heightForWidth(int width) const override {
    return picture_.isNull() ? kLeastHeight : width * picture_.height() / picture_.width();
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    if (picture_.isNull()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QSize fitted = picture_.size().scaled(size(), Qt::KeepAspectRatio);
    painter.drawImage(QRect(QPoint(0, 0), fitted), picture_);
  }

 private:
  static constexpr int kLeastHeight = 120;  // [px]
  QImage picture_;
};

/// A frame around a page of the participant: a screen within this window.
QFrame* screenAround(QWidget& page, QWidget* parent) {
  auto* screen = new QFrame(parent);
  screen->setProperty("role", QStringLiteral("screen"));
  auto* inside = new QVBoxLayout(screen);
  inside->addWidget(&page);
  return screen;
}

QString inUnits(double value, const char* unit, int decimals = 2) {
  return QString::number(value, 'f', decimals) + QLatin1Char(' ') + QString::fromUtf8(unit);
}

}  // namespace

Tour::Tour(QWidget* parent)
    : QDialog(parent),
      protocol_(shippedPunchProtocol()),
      punch_(protocol_.protocol.devices.front(), protocol_.protocol.conditions.front().scene()),
      stepCount_(quietLabel({}, this)),
      heading_(headingLabel({}, this)),
      steps_(new QStackedWidget(this)),
      back_(new QPushButton(tr("Back"), this)),
      next_(new QPushButton(this)) {
  setWindowTitle(tr("Palpate in three steps"));
  translator_.speak(deskLanguage());
  next_->setObjectName(QStringLiteral("tour-next"));
  for (auto* button : {back_, next_}) button->setAutoDefault(false);
  steps_->addWidget(makeTrialDemonstration());
  steps_->addWidget(makeQuestions());
  steps_->addWidget(makeRecord());
  auto* skip = new QPushButton(tr("Close"), this);
  skip->setAutoDefault(false);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(skip);
  buttons->addStretch(1);
  buttons->addWidget(back_);
  buttons->addWidget(next_);
  auto* layout = withMargins<QVBoxLayout>(this, {28, 22, 28, 22});
  layout->addWidget(stepCount_);
  layout->addWidget(heading_);
  layout->addWidget(scrolled(steps_, this), 1);
  layout->addLayout(buttons);
  connect(skip, &QPushButton::clicked, this, &QDialog::reject);
  connect(back_, &QPushButton::clicked, this, [this] { goTo(step() - 1); });
  connect(next_, &QPushButton::clicked, this, [this] {
    step() + 1 < kTourSteps ? goTo(step() + 1) : accept();
  });
  connect(&watch_, &QTimer::timeout, this, &Tour::showTrialState);
  resizeOnScreen(*this, {1180, 760});
  goTo(0);
}

Tour::~Tour() = default;

bool Tour::isUnseen() {
  return !studioSettings().value(QLatin1String(kTourSeenKey)).toBool();
}

void Tour::done(int result) {
  studioSettings().setValue(QLatin1String(kTourSeenKey), true);
  if (punch_.isRunning()) endTrial();
  QDialog::done(result);
}

void Tour::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  if (parentWidget() == nullptr || event->spontaneous()) return;
  // Not every window manager puts a dialog over its window.
  const QRect beside = parentWidget()->window()->frameGeometry();
  QRect own(QPoint(), size());
  own.moveCenter(beside.center());
  const QRect screen = this->screen()->availableGeometry();
  move(
      std::clamp(own.left(), screen.left(), std::max(screen.left(), screen.right() - width())),
      std::clamp(own.top(), screen.top(), std::max(screen.top(), screen.bottom() - height())));
}

QWidget* Tour::makeTrialDemonstration() {
  auto* step = new QWidget(this);
  auto* picture =
      new scene::SimulationView(std::make_unique<scene::KneeScene>(), scene::makeRenderer());
  picture->setSnapshotSource([this] {
    const auto status = punch_.status();
    return scene::TrialSnapshot{
        .travel = status.travel,
        .force = status.force,
        .isCutThrough = status.isCutThrough,
        .isRunning = punch_.isRunning(),
        .sampleTime = status.sampleTime};
  });
  picture->setAttribute(Qt::WA_TransparentForMouseEvents);  // the page around it handles the mouse
  trialPage_ = new TrialPage(
      {.title = tr("A first cut"),
       .minimumCuts = 1,
       .device = &punch_.kind(),
       .language = deskLanguage()},
      picture,
      step);
  disableMnemonics(*trialPage_);
  plot_ = new LivePlot(step);
  // Both fill the available space and request none.
  constexpr int kLeastHeight = 180;  // [px]
  for (QWidget* drawn : {static_cast<QWidget*>(picture), static_cast<QWidget*>(plot_)}) {
    drawn->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    drawn->setMinimumHeight(kLeastHeight);
  }
  // Long words of some languages wrap in a narrow window; a layout in a scroll area does not count
  // the lines.
  constexpr int kLeastPageHeight = 520;  // [px]
  trialPage_->setMinimumHeight(kLeastPageHeight);
  auto* drawings = new QVBoxLayout;
  drawings->addWidget(sectionLabel(tr("Force and travel of your hand"), step));
  drawings->addWidget(plot_, 1);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(20);
  columns->addWidget(screenAround(*trialPage_, step), 3);
  columns->addLayout(drawings, 2);
  auto* layout = withoutMargins<QVBoxLayout>(step);
  layout->addWidget(quietLabel(
      tr("Watch the force drop where the tissue gives way. With a device your fingers would feel "
         "it; here it is only drawn."),
      step));
  layout->addLayout(columns, 1);
  connect(trialPage_, &TrialPage::beginRequested, this, &Tour::begin);
  connect(trialPage_, &TrialPage::finishRequested, this, [this] {
    endTrial();
    goTo(1);
  });
  connect(trialPage_, &TrialPage::handMoved, this, [this](double share) { punch_.moveTo(share); });
  return step;
}

QWidget* Tour::makeQuestions() {
  auto* step = new QWidget(this);
  const auto& blocks = protocol_.protocol.phases;
  const auto block = std::find_if(blocks.begin(), blocks.end(), [](const auto& phase) {
    return !phase.trials.questionnaires.empty();
  });
  const auto& asked = block->trials.questionnaires.front();
  const auto* instrument = protocol_.instrument(asked.instrument);
  auto* page = new QuestionnairePage(
      {.title = tr("Alternative 1"),
       .introduction = QString::fromStdString(instrument->introduction.in(deskLanguage())),
       .items = instrument->itemsOf(asked.itemSetFor(block->trials.conditions.front())),
       .language = QString::fromStdString(deskLanguage())},
      step);
  disableMnemonics(*page);
  auto* layout = withoutMargins<QVBoxLayout>(step);
  layout->addWidget(quietLabel(
      tr("The alternative has a number, and is never named by what it is. Nothing is chosen "
         "beforehand, and every answer is on the disk before the next page. Try it: here, nothing "
         "is kept."),
      step));
  layout->addWidget(screenAround(*page, step), 1);
  return step;
}

QWidget* Tour::makeRecord() {
  auto* step = new QWidget(this);
  record_ = new QTableWidget(0, 2, step);
  record_->setObjectName(QStringLiteral("tour-record"));
  record_->setAccessibleName(tr("What is kept of a trial"));
  record_->setHorizontalHeaderLabels({tr("What is kept"), tr("Of what you just felt")});
  record_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  makeReadOnly(*record_);
  record_->setSelectionMode(QAbstractItemView::NoSelection);
  storedDataLabel_ = quietLabel({}, step);
  travelPlot_ = new TravelPlot(step);
  record_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  record_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  record_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Interactive);
  connect(record_->horizontalHeader(), &QHeaderView::sectionResized, this, &Tour::fitRecord);
  auto* own = new QVBoxLayout;
  own->addWidget(travelPlot_, 1);
  own->addWidget(record_);
  auto* report = new QVBoxLayout;
  report->addWidget(
      bodyLabel(tr("What a report shows of a whole study (simulated participants):"), step));
  report->addWidget(new FittedPicture(
      tr("A figure of a report"), QStringLiteral(":/help/pictures/figure.png"), step));
  report->addSpacing(12);
  report->addWidget(quietLabel(
      tr("In a study this lies in its folder: answers and sessions in study.db, samples in "
         "traces.db, names in identity.db and nowhere else. Everything is in a chain of hashes; "
         "Verify reads it again at any time."),
      step));
  report->addStretch(1);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(20);
  columns->addLayout(own, 1);
  columns->addLayout(report, 1);
  auto* layout = withoutMargins<QVBoxLayout>(step);
  layout->addWidget(storedDataLabel_);
  layout->addLayout(columns, 1);
  return step;
}

void Tour::goTo(int step) {
  static constexpr const char* kHeadings[]{
      "Try a cut", "What the participant sees next", "What is recorded"};
  if (punch_.isRunning()) endTrial();
  if (step == kTourSteps - 1) showRecord();
  steps_->setCurrentIndex(step);
  next_->show();
  stepCount_->setText(tr("Step %1 of %2").arg(step + 1).arg(kTourSteps));
  heading_->setText(deskText(kHeadings[step]));
  back_->setVisible(step > 0);
  const bool isSkipped = step == 0 && !trialRecord_;
  const bool isLast = step + 1 == kTourSteps;
  next_->setText(isSkipped ? tr("Skip") : isLast ? tr("Begin with a study") : tr("Next"));
  // In the first step the button of the participant's page is the one to press.
  setRole(*next_, step > 0 ? "main" : "");
}

void Tour::begin() {
  if (!attempt(this, MessageTopic::VirtualPunchNotStarted, [&] { punch_.begin(); })) return;
  plot_->begin(punch_.kind(), 1000.0);
  travelPlot_->begin(punch_.kind());
  trialPage_->setRunning(true);
  watch_.start(kTourPictureInterval);
}

void Tour::showTrialState() {
  haptics::engine::TickSample sample;
  while (punch_.nextToPlot(sample)) {
    plot_->add(sample);
    travelPlot_->add(sample);
  }
  plot_->refresh();
  const int cuts = punch_.status().cuts;
  trialPage_->setCuts(cuts);
  if (cuts == 0) return;
  // "Done" on the page is the way on now, and how a cut is made is known.
  next_->hide();
  trialPage_->findChild<QLabel*>(QStringLiteral("pointer-hint"))->hide();
}

void Tour::endTrial() {
  watch_.stop();
  punch_.moveTo(0.0);
  trialRecord_ = punch_.finish();
  trialPage_->setRunning(false);
}

void Tour::showRecord() {
  record_->setRowCount(0);
  for (auto* shown : {static_cast<QWidget*>(travelPlot_), static_cast<QWidget*>(record_)}) {
    shown->setVisible(trialRecord_.has_value());
  }
  if (!trialRecord_) {
    storedDataLabel_->setText(
        tr("You have not felt anything yet: go back to the first step, press Begin, and make a "
           "cut. Then its record appears here."));
    return;
  }
  storedDataLabel_->setText(
      tr("Proof of what was felt, and how well it was rendered. It is kept with every trial, and "
         "says whether the trial can be relied on."));
  const auto add = [&](const QString& what, const QString& value) {
    const int row = record_->rowCount();
    record_->insertRow(row);
    record_->setItem(row, 0, new QTableWidgetItem(what));
    record_->setItem(row, 1, new QTableWidgetItem(value));
  };
  travelPlot_->refresh();
  const auto& felt = *trialRecord_;
  add(tr("Samples, a thousand a second"), QString::number(punch_.samples().size()));
  add(tr("Duration"), inUnits(felt.duration, "s", 1));
  add(tr("Cuts"), QString::number(felt.cuts.size()));
  add(tr("Largest force"), inUnits(felt.largestForce, "N"));
  add(tr("In contact"), inUnits(felt.contact, "s", 1));
  if (!felt.cuts.empty() && felt.cuts.front().interception.found) {
    const double touched = felt.cuts.front().interception.travel;
    add(tr("First cut: touched the tissue at"), inUnits(touched, "units of travel"));
  }
  if (felt.lateTicks) {
    add(tr("Timing"), tr("%1 of %2 force updates late").arg(*felt.lateTicks).arg(felt.ticks));
  }
  const auto judgement = felt.judgement();
  QStringList reasons;
  for (const auto& reason : judgement.reasons) reasons << deskText(reason);
  const auto verdict = judgement.verdict == Verdict::Pass   ? tr("Usable")
                       : judgement.verdict == Verdict::Warn ? tr("Usable, with a remark")
                                                            : tr("Not to be relied on");
  add(tr("Verdict"), (QStringList(verdict) + reasons).join(QStringLiteral("; ")));
  int widest = 0;
  for (int row = 0; row < record_->rowCount(); ++row) {
    const auto name = record_->item(row, 0)->text();
    widest = std::max(widest, record_->fontMetrics().horizontalAdvance(name));
  }
  constexpr int kCellPadding = 40;  // [px] of the words in a cell
  record_->setColumnWidth(0, widest + kCellPadding);
  fitRecord();
}

/// Makes the table as high as its rows, which the width of the columns decides.
void Tour::fitRecord() {
  record_->resizeRowsToContents();
  record_->setFixedHeight(
      record_->horizontalHeader()->height() + record_->verticalHeader()->length() +
      2 * record_->frameWidth());
}

}  // namespace study::gui
