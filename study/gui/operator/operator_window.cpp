#include "study/gui/operator/operator_window.h"

#include <algorithm>
#include <utility>

#include <QCloseEvent>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenuBar>
#include <QScreen>
#include <QVBoxLayout>

#include "haptics/devices/simulated_device.h"
#include "haptics/registry/device_kinds.h"
#include "study/gui/operator/consent_copy_dialog.h"
#include "study/gui/operator/control_panel.h"
#include "study/gui/operator/device_panel.h"
#include "study/gui/operator/enrolment_check.h"
#include "study/gui/operator/page_mirror.h"
#include "study/gui/operator/sessions_page.h"
#include "study/gui/operator/timeline_table.h"
#include "study/gui/operator/trial_panel.h"
#include "study/gui/operator/window_geometries.h"
#include "study/gui/participant/questionnaire_page.h"
#include "study/gui/session/operator_pin.h"
#include "study/gui/session/trial_view.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/fitting_scroll.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/mnemonics.h"
#include "study/gui/widgets/theme.h"
#include "study/session/trial_setup.h"
#include "study/storage/trial_repository.h"
#include "study/trial/hardware_device_set.h"

namespace study::gui {

/// Only the page that is shown needs room.
static void giveRoomToCurrentPage(QStackedWidget& pages) {
  for (int i = 0; i < pages.count(); ++i) {
    const auto room = i == pages.currentIndex() ? QSizePolicy::Preferred : QSizePolicy::Ignored;
    pages.widget(i)->setSizePolicy(room, room);
  }
}

OperatorWindow::OperatorWindow(Study& study, const std::string& deviceFile, QWidget* parent)
    : QMainWindow(parent),
      study_(study),
      deviceSet_(deviceSetFor(
          deviceFile, study.folder(), [this](const auto& need) { return hands_.make(need); })),
      push_(study, [this] { return controller_ && controller_->isTrialRunning(); }) {
  const auto title = QString::fromStdString(study.protocol().protocol.study.title);
  setWindowTitle(tr("Palpate — %1").arg(title));
  makeContents();
  constexpr QSize kComfortable(1280, 860);
  const QSize available = screen()->availableSize();
  resize(kComfortable.boundedTo(available));
  // A desktop adds its frame around a window as large as the screen, which would push the last line
  // off the screen.
  if (kComfortable.boundedTo(available) != kComfortable) setWindowState(Qt::WindowMaximized);
  connect(&stopKey_, &StopKey::pressed, this, &OperatorWindow::stop);
  connect(&cutKey_, &CutKey::pressed, this, [this] {
    if (controller_) controller_->changeBenchmarkCuts(1);
  });
}

void OperatorWindow::makeContents() {
  delete takeCentralWidget();  // at once: while it is there, its texts keep their letters with Alt
  language_ = deskLanguage();
  pages_ = new QStackedWidget(this);
  sessionPages_ = new QStackedWidget(this);
  sessions_ = new SessionsPage(study_, push_, this);
  controls_ = new ControlPanel(this);
  trial_ = new TrialPanel(this);
  steps_ = new TimelineTable(this);
  devices_ = new DevicePanel(study_.protocol().protocol, *deviceSet_, this);
  if (devices_->usesVirtualDevices()) sessions_->offerPilot();
  delete mirror_;  // a separate window, which is not among the contents
  mirror_ = new PageMirror(this);
  menuBar()->clear();
  makeMenus();
  auto* inside = new QWidget(this);
  auto* layout = withMargins<QVBoxLayout>(inside, {20, 14, 20, 14}, 10);
  head_ = makeHead();
  layout->addWidget(head_);
  pages_->addWidget(sessions_);
  pages_->addWidget(makeSession());
  for (auto* stack : {pages_, sessionPages_}) {
    connect(
        stack, &QStackedWidget::currentChanged, this, [stack] { giveRoomToCurrentPage(*stack); });
    giveRoomToCurrentPage(*stack);
  }
  layout->addWidget(pages_, 1);
  setCentralWidget(new FittingScroll(inside, this));
  connectPanels();
  arrange();
}

void OperatorWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::LanguageChange || language_ == deskLanguage()) return;
  // The menu that chose the language is still open.
  QTimer::singleShot(0, this, [this] {
    if (!controller_ && language_ != deskLanguage()) makeContents();
  });
}

void OperatorWindow::makeMenus() {
  auto* view = menuBar()->addMenu(tr("&View"));
  addThemesTo(*view->addMenu(tr("&Theme")));
  languages_ = view->addMenu(tr("&Language"));
  addLanguagesTo(*languages_);
  auto* mirror = view->addAction(tr("&Participant's page"));
  mirror->setCheckable(true);
  mirror->setObjectName(QStringLiteral("show-mirror"));
  connect(mirror, &QAction::toggled, mirror_, &QWidget::setVisible);
  forces_ = view->addAction(tr("&Force curves"));
  forces_->setCheckable(true);
  forces_->setObjectName(QStringLiteral("show-forces"));
  connect(forces_, &QAction::triggered, this, &OperatorWindow::switchForces);
  view->addAction(tr("&Windows side by side"), this, &OperatorWindow::tile);
  auto* help = menuBar()->addMenu(tr("&Help"));
  // The application shows help on F1, for whatever has the focus.
  help->addAction(tr("&Help for this window\tF1"), this, [this] {
    QCoreApplication::postEvent(this, new QKeyEvent(QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier));
  });
}

/// The header, which is visible in a session and between sessions: the study and the state of its
/// devices.
QWidget* OperatorWindow::makeHead() {
  auto* head = new QWidget(this);
  auto* lines = withoutMargins<QVBoxLayout>(head, 2);
  const auto& protocol = study_.protocol().protocol;
  auto* title = headingLabel(QString::fromStdString(protocol.study.title), head);
  lines->addWidget(title);
  lines->addWidget(devices_);
  return head;
}

QWidget* OperatorWindow::makeSession() {
  auto* page = new QWidget(this);
  columns_ = withoutMargins<QHBoxLayout>(page, 20);
  columns_->addWidget(controls_);
  sessionPages_->addWidget(trial_);
  columns_->addWidget(scrolled(sessionPages_, page), 1);
  showForces(true);
  return page;
}

void OperatorWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  arrange();
}

/// Puts the buttons beside the trial, or above it in a narrow window.
void OperatorWindow::arrange() {
  // In a narrow window the header's lines wrap, which the minimum height of the contents does not
  // include.
  constexpr int kMarginsAndScrollBar = 60;  // [px]: margins and scroll bar
  head_->setMinimumHeight(head_->layout()->totalHeightForWidth(width() - kMarginsAndScrollBar));
  constexpr int kLeastWidthOfTwoColumns = 900;  // [px]
  constexpr int kLeastControls = 345;
  constexpr int kMostControls = 470;
  const int controls = std::clamp(width() * 33 / 100, kLeastControls, kMostControls);
  constexpr int kHeightOfEach = 420;  // above one another
  const bool isWide = width() >= kLeastWidthOfTwoColumns;
  columns_->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  controls_->setMinimumWidth(isWide ? controls : 0);
  controls_->setMaximumWidth(isWide ? controls : QWIDGETSIZE_MAX);
  controls_->setMinimumHeight(isWide ? 0 : kHeightOfEach);
  sessionPages_->parentWidget()->parentWidget()->setMinimumHeight(isWide ? 0 : kHeightOfEach);
}

void OperatorWindow::connectPanels() {
  connect(sessions_, &SessionsPage::closeRequested, this, &QWidget::close);
  connect(sessions_, &SessionsPage::enrolRequested, this, &OperatorWindow::enrolAfterChecks);
  connect(
      sessions_,
      &SessionsPage::resumeRequested,
      this,
      [this](qlonglong id, const QString& takeOver) {
        resumeAfterChecks(SessionId{id}, takeOver.toStdString());
      });
  connect(controls_, &ControlPanel::handOverRequested, this, &OperatorWindow::handOver);
  connect(controls_, &ControlPanel::consentCopyRequested, this, [this] {
    if (controller_) saveConsentCopy(study_, controller_->session().participant(), this);
  });
  connect(controls_, &ControlPanel::interviewFinished, this, [this] {
    if (interview_ != nullptr) controller_->finishStep();
  });
  connect(controls_, &ControlPanel::closeSessionRequested, this, &OperatorWindow::endSession);
}

OperatorWindow::~OperatorWindow() {
  mirror_->setPage(nullptr);
  if (controller_) controller_->disconnect(this);
  trial_->setController(nullptr);
  controls_->setController(nullptr);
}

void OperatorWindow::enrol(const Enrolment& enrolment) {
  if (controller_) return;
  attempt(this, MessageTopic::SessionNotBegun, [&] { begin(Session::enrol(study_, enrolment)); });
}

void OperatorWindow::resume(SessionId id, const std::string& takeOver) {
  if (controller_) return;
  attempt(this, MessageTopic::SessionNotContinued, [&] {
    begin(Session::resume(study_, id, takeOver));
  });
}

void OperatorWindow::enrolAfterChecks(const Enrolment& enrolment) {
  if (controller_) return;
  attempt(this, MessageTopic::SessionNotBegun, [&] {
    const bool mayBegin = confirmTexts(study_.protocol(), enrolment, this) &&
                          confirmNewestCopy(study_, enrolment, this);
    if (mayBegin && devices_->confirmDevicesReady()) enrol(enrolment);
  });
}

void OperatorWindow::resumeAfterChecks(SessionId id, const std::string& takeOver) {
  if (controller_ || !devices_->confirmDevicesReady()) return;
  bool mayGoOn = false;
  attempt(this, MessageTopic::SessionNotContinued, [&] { mayGoOn = confirmVirtualDevices(id); });
  if (mayGoOn) resume(id, takeOver);
}

/// Asks before a session that was felt on an instrument goes on with virtual devices, as when the
/// program was started again without its device file.
bool OperatorWindow::confirmVirtualDevices(SessionId id) {
  if (!devices_->usesVirtualDevices()) return true;
  QStringList real;
  for (const auto& name : storage::TrialRepository(study_.database()).devices(id)) {
    const bool isVirtual = std::ranges::any_of(haptics::deviceKinds(), [&](const auto* kind) {
      return haptics::devices::simulated(*kind).name == name;
    });
    if (!isVirtual) real << QString::fromStdString(name);
  }
  return real.isEmpty() ||
         ask(this, MessageTopic::GoOnVirtually, {real.join(QStringLiteral(", "))});
}

void OperatorWindow::begin(Session session) {
  controller_ = std::make_unique<SessionController>(study_, *deviceSet_, std::move(session));
  followSession();
  useSessionLanguage();
  participant_ = std::make_unique<ParticipantWindow>(*controller_, pin_, [this](double share) {
    moveHand(controller_->session(), hands_, share);
  });
  connect(
      &participant_->lock(),
      &ScreenLock::opened,
      this,
      &OperatorWindow::takeScreenBack,
      Qt::QueuedConnection);
  trial_->setController(controller_.get());
  controls_->setController(controller_.get());
  mirror_->setPage(participant_.get(), controller_->session().participant());
  languages_->menuAction()->setEnabled(false);  // until the session's end
  showForces(!controller_->session().isBlinded());
  pages_->setCurrentIndex(1);
  // Until they were shown, the buttons had not the theme's margins, and asked for more room.
  for (auto* button : controls_->findChildren<QPushButton*>()) button->updateGeometry();
  updateAll();
  showParticipant();
}

void OperatorWindow::followSession() {
  const auto* session = controller_.get();
  connect(session, &SessionController::stepChanged, this, &OperatorWindow::updateAll);
  connect(session, &SessionController::trialChanged, trial_, &TrialPanel::updateTrial);
  connect(session, &SessionController::trialChanged, controls_, &ControlPanel::updateTrial);
  connect(session, &SessionController::benchmarkCutsChanged, controls_, &ControlPanel::refresh);
  connect(session, &SessionController::languageChanged, this, &OperatorWindow::useSessionLanguage);
  connect(session, &SessionController::failed, this, &OperatorWindow::showError);
  connect(session, &SessionController::aboutToLeave, this, [this] {
    if (interview_ != nullptr) interview_->flush();
  });
}

/// Shows a message. While the participant's window is locked it waits for the PIN, because the
/// locked window covers it.
void OperatorWindow::showError(const QString& why) {
  if (participant_ && participant_->lock().isLocked()) {
    waitingErrors_ << why;
    return;
  }
  showMessage(this, MessageTopic::StepNotDone, {}, why);
}

/// After the right PIN: puts the windows where they were at the start of the session, this one in
/// front.
void OperatorWindow::takeScreenBack() {
  if (!participant_) return;
  showParticipant();
  raise();
  activateWindow();
  showWaitingErrors();
}

void OperatorWindow::showWaitingErrors() {
  const auto told = std::exchange(waitingErrors_, {});
  if (!told.isEmpty()) showError(told.join(QStringLiteral("\n\n")));
}

void OperatorWindow::stop() {
  if (controller_) controller_->stop();
}

void OperatorWindow::handOver() {
  if (!participant_) return;
  if (!pin_.isChosen()) {
    const auto chosen = askForNewPin(this);
    if (!chosen) return;
    pin_.choose(*chosen);
  }
  trial_->closeBoneWindow();
  participant_->lock().lock();
}

void OperatorWindow::showParticipant() {
  const auto screens = QGuiApplication::screens();
  if (screens.size() > 1) {
    auto* other = screens.front() == screen() ? screens.back() : screens.front();
    participant_->setGeometry(other->geometry());
    participant_->showFullScreen();
  } else {
    participant_->resize(1100, 760);
    participant_->show();
    tile();
    constexpr int kUntilFramed = 300;                               // [ms]
    QTimer::singleShot(kUntilFramed, this, &OperatorWindow::tile);  // with the frame as it is
  }
}

/// The size of the frame that the desktop adds to @p window. A desktop tells it only after it has
/// shown the window; until then it is taken for a title of the usual height.
static QSize frameOf(const QWidget& window) {
  constexpr QSize kUsual(0, 40);  // [px]
  const QSize frame = window.frameSize() - window.size();
  return frame.height() > 0 ? frame : kUsual;
}

/// Puts both windows side by side if one screen has room for them, and otherwise the participant's
/// beside the button that stops.
void OperatorWindow::tile() {
  const QRect available = screen()->availableGeometry();
  if (!participant_ || participant_->lock().isLocked()) return;
  const auto places = windowGeometriesOn(available);
  const auto beside = placeBesideStop(available);
  if (!places && !beside) return;
  participant_->setWindowState(Qt::WindowNoState);
  if (places) {
    setWindowState(Qt::WindowNoState);
    move(places->own.topLeft());
    resize(places->own.size() - frameOf(*this));
  } else {
    setWindowState(Qt::WindowMaximized);
  }
  const QRect& place = places ? places->participant : *beside;
  participant_->move(place.topLeft());
  participant_->resize(place.size() - frameOf(*participant_));
}

void OperatorWindow::useSessionLanguage() {
  translator_.speak(controller_->session().language());
}

/// On the operator's request. In a blinded session it is asked and noted first.
void OperatorWindow::switchForces(bool areShown) {
  const bool isBlinded = controller_ && controller_->session().isBlinded();
  bool isDone = true;
  if (isBlinded && areShown) isDone = ask(this, MessageTopic::ShowForces);
  if (isBlinded && isDone) isDone = controller_ && controller_->noteForcesShown(areShown);
  showForces(isDone ? areShown : !areShown);
}

/// Shows the forces, with the steps of the session below the buttons, or the steps in their place.
void OperatorWindow::showForces(bool areShown) {
  forces_->setChecked(areShown);
  trial_->showForces(areShown);
  areShown ? controls_->takeSteps(*steps_) : trial_->takeSteps(*steps_);
}

void OperatorWindow::updateAll() {
  steps_->show(controller_.get());
  trial_->updateStep();
  stopKey_.setArmed(controller_->isTrialRunning());
  devices_->setBusy(controller_->isTrialRunning());
  controls_->refresh();
  showInterview();
}

void OperatorWindow::removeInterview() {
  if (interview_ == nullptr) return;
  if (interview_->isAncestorOf(focusWidget())) setFocus();  // otherwise a button would take it
  sessionPages_->removeWidget(interview_);
  interview_->deleteLater();
  interview_ = nullptr;
}

void OperatorWindow::showInterview() {
  removeInterview();
  const auto& session = controller_->session();
  if (session.isOver() || session.state() == SessionState::Paused) return;
  if (session.step().kind != StepKind::Interview) return;
  const auto* instrument = session.instrument();
  interview_ = new QuestionnairePage(
      {.title = QString::fromStdString(instrument->title.in(session.language())),
       .introduction = QString::fromStdString(instrument->introduction.in(session.language())),
       .items = session.items(),
       .language = QString::fromStdString(session.language()),  // of the person who is asked
       .before = session.answers()},
      this);
  disableMnemonics(*interview_);
  connect(interview_, &QuestionnairePage::answered, controller_.get(), &SessionController::answer);
  connect(
      interview_, &QuestionnairePage::retracted, controller_.get(), &SessionController::retract);
  connect(
      controller_.get(), &SessionController::notSaved, interview_, &QuestionnairePage::markUnsaved);
  sessionPages_->addWidget(interview_);
  sessionPages_->setCurrentWidget(interview_);
  interview_->setFocus();  // otherwise a button would get the focus
}

void OperatorWindow::endSession() {
  if (!controller_ || controller_->isTrialRunning()) return;
  if (!controller_->savePending() && !ask(this, MessageTopic::CloseWithLoss)) return;
  trial_->setController(nullptr);
  controls_->setController(nullptr);
  steps_->show(nullptr);
  mirror_->setPage(nullptr);
  participant_->allowClosing();
  participant_->close();
  participant_.reset();
  removeInterview();
  controller_.reset();
  languages_->menuAction()->setEnabled(true);
  sessions_->refresh();
  pages_->setCurrentIndex(0);
  push_.send();
}

void OperatorWindow::closeEvent(QCloseEvent* event) {
  if (controller_ && controller_->isTrialRunning()) {
    MessageBox box(MessageTopic::TrialIsRunning, {}, {}, this);
    connect(controller_.get(), &SessionController::stepChanged, &box, &QDialog::reject);
    box.exec();
    event->ignore();
    return;
  }
  endSession();
  event->setAccepted(!controller_);
}

}  // namespace study::gui
