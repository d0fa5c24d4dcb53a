#include "study/gui/authoring/preview_window.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include "study/cohort/simulated_participant.h"
#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/session/operator_pin.h"
#include "study/gui/session/session_controller.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"
#include "study/session/trial_setup.h"
#include "study/trial/device_set.h"

namespace study::gui {
namespace {

constexpr std::uint64_t kSeed = 1;

constexpr QSize kSizes[]{{1280, 720}, {1366, 768}, {1920, 1080}, {2560, 1440}, {3840, 2160}};

/// The size of the screen on which participants see the pages: another one than that of @p desk, if
/// there is one.
QSize participantsScreen(const QWidget& desk) {
  const auto screens = QGuiApplication::screens();
  const auto other =
      std::ranges::find_if(screens, [&](const QScreen* each) { return each != desk.screen(); });
  return (other == screens.end() ? desk.screen() : *other)->size();
}

/// A step by the title of the page that it shows; by its phase, if several steps show that page.
QString titleOf(const Step& step, const protocols::LoadedProtocol& loaded) {
  const auto words = describe(step, loaded.protocol.labels);
  const auto* phase = loaded.protocol.phase(step.phase);
  const bool hasPage = phase != nullptr && step.kind != StepKind::Trial &&
                       step.kind != StepKind::Questionnaire && !step.isOptionalTrial;
  const auto* shown = hasPage ? loaded.instrument(phase->instrument) : nullptr;
  if (shown == nullptr) return words;
  const auto title = QString::fromStdString(shown->title.in(deskLanguage()));
  const auto uses =
      std::ranges::count(loaded.protocol.phases, phase->instrument, &protocols::Phase::instrument);
  return uses == 1 ? title : QStringLiteral("%1 (%2)").arg(title, words);
}

/// Begins a session in the study in @p folder and lets a simulated participant go to @p step.
SessionId sessionAt(const std::string& folder, const std::string& language, int step) {
  SimulatedClock clock;
  auto study = Study::open(folder, clock);
  const auto& cohorts = study.protocol().protocol.cohorts;
  auto session = Session::enrol(
      study,
      {.cohort = cohorts.front().id, .runMode = RunMode::Pilot, .language = language, .code = {}});
  simulateUntil(study, session, clock, kSeed, step);
  return session.id();
}

}  // namespace

/// A session with its devices and its window. Each member uses those before it.
struct PreviewWindow::PreviewSession {
  PreviewSession(const std::string& folder, SessionId id)
      : study(Study::open(folder)),
        devices([this](const auto& need) { return hands.make(need); }),
        controller(study, devices, Session::resume(study, id)),
        window(std::make_unique<ParticipantWindow>(controller, pin, [this](double share) {
          moveHand(controller.session(), hands, share);
        })) {}

  ~PreviewSession() { window->allowClosing(); }

  Study study;
  PointerHands hands;
  SimulatedDeviceSet devices;
  SessionController controller;
  OperatorPin pin;
  std::unique_ptr<ParticipantWindow> window;
};

PreviewWindow::PreviewWindow(const protocols::LoadedProtocol& loaded, QWidget* parent)
    : QMainWindow(parent),
      loaded_(loaded),
      steps_(new QListWidget(this)),
      languages_(new QComboBox(this)),
      sizes_(new QComboBox(this)),
      messageLabel_(quietLabel({}, this)),
      bar_(new QHBoxLayout),
      scroll_(new QScrollArea(this)),
      folder_(std::make_unique<QTemporaryDir>()) {
  setWindowTitle(
      tr("Preview as participant — %1").arg(QString::fromStdString(loaded.protocol.study.title)));
  auto* inside = new QWidget(this);
  auto* layout = withMargins<QVBoxLayout>(inside, {16, 12, 16, 12});
  makeBar(*layout);
  auto* sides = new QSplitter(Qt::Horizontal, this);
  sides->addWidget(steps_);
  sides->addWidget(scroll_);
  sides->setStretchFactor(1, 1);
  sides->setSizes({360, 1000});
  layout->addWidget(sides, 1);
  layout->addWidget(messageLabel_);
  constexpr int kLeastWidth = 640;  // [px]: of the bar in two lines
  inside->setMinimumWidth(kLeastWidth);
  setCentralWidget(inside);
  resizeOnScreen(*this, {1360, 860});
  steps_->setAccessibleName(tr("Steps of the session"));
  steps_->setObjectName(QStringLiteral("steps"));
  steps_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  steps_->setWordWrap(true);
  steps_->setResizeMode(QListView::Adjust);
  scroll_->setAlignment(Qt::AlignCenter);
  scroll_->setProperty("role", QStringLiteral("screen"));
  scroll_->setAccessibleName(tr("Page of the participant"));
  scroll_->viewport()->installEventFilter(this);
  if (const auto left = blanksLeft(loaded_); left > 0) {
    blanks_ =
        QStringLiteral(" ") +
        tr("Texts that are still blank: %1. They are marked on the pages, and have to be filled in "
           "before a live session.")
            .arg(left);
    setRole(*messageLabel_, "warn");
  }
  SystemClock clock;
  const auto folder = folder_->filePath(QStringLiteral("study")).toStdString();
  Study::create(folder, loaded_, clock, kSeed);
  goTo(0);
  fillSteps();
  connect(steps_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0) attempt(this, MessageTopic::PreviewNotShown, [&] { goTo(row); });
  });
  connect(languages_, &QComboBox::currentIndexChanged, this, &PreviewWindow::chooseLanguage);
  connect(sizes_, &QComboBox::currentIndexChanged, this, &PreviewWindow::fitPage);
  connect(&stopKey_, &StopKey::pressed, this, [this] { previewSession_->controller.stop(); });
  connect(&cutKey_, &CutKey::pressed, this, [this] {
    previewSession_->controller.changeBenchmarkCuts(1);
  });
}

PreviewWindow::~PreviewWindow() {
  QCoreApplication::removeTranslator(&translator_);
  previewSession_->controller.disconnect(this);
  previewSession_.reset();  // before its folder
}

void PreviewWindow::makeBar(QVBoxLayout& layout) {
  languages_->setAccessibleName(tr("Language"));
  languages_->setObjectName(QStringLiteral("language"));
  addLanguages(*languages_, loaded_.protocol.languages);
  sizes_->setAccessibleName(tr("Size of the participant's screen"));
  sizes_->setObjectName(QStringLiteral("size"));
  const QSize own = participantsScreen(*this);
  sizes_->addItem(tr("Participant's screen: %1 × %2").arg(own.width()).arg(own.height()), own);
  sizes_->addItem(tr("As large as this window"), QSize());
  for (const auto& size : kSizes) {
    sizes_->addItem(tr("Screen of %1 × %2").arg(size.width()).arg(size.height()), size);
  }
  auto* back = new QPushButton(tr("Previous page"), this);
  auto* next = new QPushButton(tr("Next page"), this);
  const auto move = [this](int by) {
    const int row = steps_->currentRow() + by;
    if (row >= 0 && row < steps_->count()) steps_->setCurrentRow(row);
  };
  connect(back, &QPushButton::clicked, this, [move] { move(-1); });
  connect(next, &QPushButton::clicked, this, [move] { move(1); });
  auto* again = new QPushButton(tr("Restart this page"), this);
  again->setObjectName(QStringLiteral("again"));
  connect(again, &QPushButton::clicked, this, [this] {
    attempt(this, MessageTopic::PreviewNotShown, [&] { goTo(steps_->currentRow()); });
  });
  auto* pages = new QHBoxLayout;
  for (auto* button : {back, next, again}) {
    button->setProperty("role", QStringLiteral("tool"));
    pages->addWidget(button);
  }
  auto* looks = new QHBoxLayout;
  looks->addWidget(languages_);
  looks->addWidget(sizes_);
  looks->addStretch(1);
  languagesLabel_ = new QLabel(tr("Preview in"), this);
  looks->insertWidget(0, languagesLabel_);
  bar_->addLayout(pages);
  bar_->addLayout(looks, 1);
  layout.addLayout(bar_);
}

/// Arranges the bar's controls in one line, or in two in a narrow window.
void PreviewWindow::resizeEvent(QResizeEvent* event) {
  constexpr int kRoomForOneLine = 1120;  // [px]
  bar_->setDirection(
      width() >= kRoomForOneLine ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  QMainWindow::resizeEvent(event);
}

std::string PreviewWindow::language() const {
  return languages_->currentData().toString().toStdString();
}

void PreviewWindow::fillSteps() {
  constexpr QChar kFigureSpace(0x2007);  // as wide as a digit
  const QSignalBlocker quiet(steps_);
  int number = 0;
  for (const auto& step : previewSession_->controller.session().plan()) {
    steps_->addItem(
        QStringLiteral("%1  %2").arg(++number, 2, 10, kFigureSpace).arg(titleOf(step, loaded_)));
  }
  steps_->addItem(tr("End"));
  steps_->setCurrentRow(0);
}

void PreviewWindow::goTo(int step) {
  const auto folder = folder_->filePath(QStringLiteral("study")).toStdString();
  if (previewSession_) {
    auto& controller = previewSession_->controller;
    controller.disconnect(this);
    scroll_->takeWidget();  // previewSession_ owns it
    // The next session takes the same place, with the same order and labels.
    if (!controller.session().isOver()) controller.withdraw(QStringLiteral("another page"));
  }
  previewSession_.reset();
  const auto id = sessionAt(folder, language(), step);
  translator_.speak(language());
  previewSession_ = std::make_unique<PreviewSession>(folder, id);
  showSession();
}

void PreviewWindow::showSession() {
  auto* page = previewSession_->window.get();
  scroll_->setWidget(page);
  page->setParent(scroll_->viewport(), Qt::Widget);
  fitPage();
  page->show();
  const auto* controller = &previewSession_->controller;
  connect(controller, &SessionController::languageChanged, this, [this, controller] {
    const QSignalBlocker quiet(languages_);
    gui::chooseLanguage(*languages_, controller->session().language());
    translator_.speak(language());
  });
  connect(controller, &SessionController::stepChanged, this, &PreviewWindow::updateStep);
  connect(controller, &SessionController::failed, this, [this](const QString& why) {
    messageLabel_->setText(why);
  });
  updateStep();
}

void PreviewWindow::updateStep() {
  const auto& controller = previewSession_->controller;
  const auto& session = controller.session();
  stopKey_.setArmed(controller.isTrialRunning());
  // The first page has a choice of its own, as it has for participants.
  const bool isOnPage = session.stepIndex() == 0 && !session.isOver();
  for (QWidget* choice :
       {static_cast<QWidget*>(languagesLabel_), static_cast<QWidget*>(languages_)}) {
    choice->setVisible(languages_->count() > 1 && !isOnPage);
  }
  messageLabel_->setText(
      session.state() == SessionState::Interrupted
          ? tr("The trial broke off. In a session the operator would decide; choose a page here.")
          : tr("A preview: nothing is saved. Answers on earlier pages are examples.") + blanks_);
  const QSignalBlocker quiet(steps_);
  steps_->setCurrentRow(session.isOver() ? steps_->count() - 1 : session.stepIndex());
}

void PreviewWindow::chooseLanguage() {
  if (previewSession_->controller.session().isOver()) {
    attempt(this, MessageTopic::PreviewNotShown, [&] { goTo(steps_->currentRow()); });
    return;
  }
  translator_.speak(language());
  previewSession_->controller.chooseLanguage(languages_->currentData().toString());
}

bool PreviewWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && previewSession_) fitPage();
  return QMainWindow::eventFilter(watched, event);
}

void PreviewWindow::fitPage() {
  const auto screen = sizes_->currentData().toSize();
  scroll_->setWidgetResizable(screen.isEmpty());
  page().showAsOn(screen);
  if (screen.isEmpty()) {
    page().setMinimumSize(0, 0);
    page().setMaximumSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
    return;
  }
  constexpr QSize kLeast(480, 270);  // [px]: what is smaller cannot be read
  const QSize room = scroll_->maximumViewportSize().expandedTo(kLeast);
  const bool hasRoom = screen.boundedTo(room) == screen;
  page().setFixedSize(hasRoom ? screen : screen.scaled(room, Qt::KeepAspectRatio));
}

const SessionController& PreviewWindow::controller() const {
  return previewSession_->controller;
}

QString PreviewWindow::folder() const {
  return folder_->path();
}

ParticipantWindow& PreviewWindow::page() {
  return *previewSession_->window;
}

void openPreview(const protocols::LoadedProtocol& loaded, QWidget* parent) {
  attempt(parent, MessageTopic::PreviewNotShown, [&] {
    auto* window = new PreviewWindow(loaded);
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->setAttribute(Qt::WA_QuitOnClose, false);
    QObject::connect(parent, &QObject::destroyed, window, &QObject::deleteLater);
    window->show();
  });
}

}  // namespace study::gui
