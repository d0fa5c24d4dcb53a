#include "study/gui/operator/control_panel.h"

#include <algorithm>
#include <array>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "study/gui/operator/timeline_table.h"
#include "study/gui/session/session_controller.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/fitting_scroll.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/message_box.h"

namespace study::gui {
namespace {

/// The question that says what will happen in the present state and step of the session.
MessageTopic topicInState(MessageTopic topic, const Session& session) {
  const bool isTrial = !session.isOver() && session.step().kind == StepKind::Trial;
  const bool isBroken = session.state() == SessionState::Interrupted;
  if (topic == MessageTopic::RepeatStep && isBroken) return MessageTopic::RepeatTrial;
  if (topic == MessageTopic::SkipStep && isTrial) return MessageTopic::SkipTrial;
  return topic;
}

/// The arguments of a question: the number and the name of the step to repeat.
QStringList argumentsOf(MessageTopic topic, const Session& session) {
  if (topic != MessageTopic::RepeatStep) return {};
  const int step = session.stepToRepeat();
  auto name =
      describe(session.plan()[static_cast<std::size_t>(step)], session.protocol().protocol.labels);
  const auto space = name.lastIndexOf(u' ');  // "Alternative 2" stays in one line
  if (space >= 0) name[space] = QChar::Nbsp;
  return {QString::number(step + 1), name};
}

}  // namespace

ControlPanel::ControlPanel(QWidget* parent)
    : QWidget(parent),
      participantLabel_(headingLabel({}, this)),
      cohort_(quietLabel({}, this)),
      stop_(new QPushButton(tr("STOP the force"), this)),
      state_(new StateLine(this)),
      saveTrial_(new QPushButton(tr("Save the trial"), this)),
      resume_(new QPushButton(tr("Continue"), this)),
      interviewDone_(new QPushButton(tr("Interview done"), this)),
      countCut_(new QPushButton(tr("Count a cut (F9)"), this)),
      uncountCut_(new QPushButton(tr("One less"), this)),
      handOver_(new QPushButton(tr("Hand over…"), this)),
      consent_(new QPushButton(tr("Consent copy…"), this)),
      close_(new QPushButton(tr("Close session"), this)),
      note_(new QLineEdit(this)),
      notes_(new QListWidget(this)) {
  participantLabel_->setObjectName(QStringLiteral("who"));
  stop_->setProperty("role", QStringLiteral("stop"));
  stop_->setToolTip(tr("Also Esc, Pause, F12, or a foot switch that types one of them"));
  resume_->setToolTip(tr("End the pause"));
  handOver_->setToolTip(tr("The participant's window covers the screen until your PIN"));
  consent_->setToolTip(tr("A copy of the signed consent, for the participant"));
  notes_->setAccessibleName(tr("Notes of this session"));
  notes_->setFocusPolicy(Qt::NoFocus);
  notes_->setWordWrap(true);
  note_->setPlaceholderText(tr("Note, with the time; Enter saves it"));
  note_->setAccessibleName(tr("Note"));
  auto* layout = withoutMargins<QVBoxLayout>(this, 10);
  layout->addWidget(participantLabel_);
  layout->addWidget(cohort_);
  layout->addWidget(stop_);
  layout->addWidget(state_);
  scroll_ = scrolled(makeButtons(), this);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->viewport()->installEventFilter(this);
  layout->addWidget(scroll_, 1);
  connectButtons();
  refresh();
}

QWidget* ControlPanel::makeButtons() {
  auto* inside = new QWidget(this);
  buttons_ = withoutMargins<QVBoxLayout>(inside, 8);
  buttons_->addWidget(note_);
  const auto repeat =
      add(tr("Repeat…"),
          SessionEvent::RepeatedStep,
          MessageTopic::RepeatStep,
          &SessionController::repeatStep);
  const auto skip = add(
      tr("Skip…"), SessionEvent::SkippedStep, MessageTopic::SkipStep, &SessionController::skipStep);
  pause_ =
      add(tr("Pause…"),
          SessionEvent::PausedSession,
          MessageTopic::PauseSession,
          &SessionController::pause);
  countCut_->setToolTip(tr("The participant has made a cut with the real instrument"));
  // At most one of "Save the trial", "Pause…" and "Continue" is shown, and of the other two.
  now_ = addGroup(
      tr("Now"),
      {{saveTrial_, pause_, resume_, interviewDone_}, {countCut_, uncountCut_}, {repeat, skip}});
  addGroup(tr("Session"), {{handOver_, consent_}, {close_}});
  const auto withdraw =
      add(tr("Participant withdraws…"),
          SessionEvent::Withdrew,
          MessageTopic::Withdrawal,
          &SessionController::withdraw);
  const auto reject =
      add(tr("Reject session…"),
          SessionEvent::WasRejected,
          MessageTopic::Rejection,
          &SessionController::reject,
          tr("This session does not count: it ends"));
  const auto fail =
      add(tr("Device failed…"),
          SessionEvent::GaveUpOnDevice,
          MessageTopic::DeviceFailure,
          &SessionController::giveUpOnDevice,
          tr("The device cannot go on: the session ends"));
  ends_ = addGroup({}, {{withdraw}, {reject, fail}});
  constexpr int kTwoNotes = 76;  // [px]
  notes_->setMinimumHeight(kTwoNotes);
  buttons_->addWidget(notes_, 2);
  buttons_->addStretch(1);
  return inside;
}

/// A heading, and buttons row by row below it.
/// @return the heading.
QLabel* ControlPanel::addGroup(
    const QString& title, const std::vector<std::vector<QPushButton*>>& rows) {
  auto* heading = quietLabel(title, this);
  buttons_->addWidget(heading);
  for (const auto& row : rows) {
    auto* line = new QHBoxLayout;
    line->setSpacing(8);
    buttons_->addLayout(line);
    for (auto* button : row) {
      button->setProperty("role", QStringLiteral("tool"));
      button->setAccessibleDescription(title);
      // A click does not move the focus, so that a space typed later presses no button.
      button->setFocusPolicy(Qt::TabFocus);
      line->addWidget(button, 1);
    }
  }
  return heading;
}

void ControlPanel::takeSteps(TimelineTable& steps) {
  constexpr int kAlmostAll = 1000;  // of the space that the buttons leave
  buttons_->addWidget(&steps, kAlmostAll);
  steps_ = &steps;
  fitSteps();
}

void ControlPanel::fitSteps() {
  if (steps_ == nullptr || !isAncestorOf(steps_)) return;
  const int others = buttons_->minimumSize().height() - steps_->minimumHeight();
  steps_->scrollItself(scroll_->viewport()->height() >= others + TimelineTable::kLeastHeight);
}

bool ControlPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) fitSteps();
  return QWidget::eventFilter(watched, event);
}

void ControlPanel::connectButtons() {
  connect(stop_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->stop();
  });
  connect(saveTrial_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->saveTrial();
  });
  connect(resume_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->resume();
  });
  connect(interviewDone_, &QPushButton::clicked, this, &ControlPanel::interviewFinished);
  connect(countCut_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->changeBenchmarkCuts(1);
  });
  connect(uncountCut_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->changeBenchmarkCuts(-1);
  });
  connect(note_, &QLineEdit::returnPressed, this, &ControlPanel::saveNote);
  connect(handOver_, &QPushButton::clicked, this, &ControlPanel::handOverRequested);
  connect(consent_, &QPushButton::clicked, this, &ControlPanel::consentCopyRequested);
  connect(close_, &QPushButton::clicked, this, &ControlPanel::closeSessionRequested);
}

QPushButton* ControlPanel::add(
    const QString& text,
    SessionEvent event,
    MessageTopic topic,
    Perform action,
    const QString& help) {
  auto* button = new QPushButton(text, this);
  button->setToolTip(help);
  choices_.push_back({button, event});
  connect(button, &QPushButton::clicked, this, [this, action, topic] {
    performWithReason(action, topic);
  });
  return button;
}

void ControlPanel::performWithReason(Perform action, MessageTopic topic) {
  if (controller_ == nullptr) return;
  controller_->stop();  // no force while the operator types a reason
  const auto& session = controller_->session();
  topic = topicInState(topic, session);
  const auto reason = askForText(this, topic, argumentsOf(topic, session));
  if (reason && controller_ != nullptr) (controller_->*action)(*reason);
  keepFocusOffButtons();
}

void ControlPanel::saveNote() {
  if (controller_ == nullptr || note_->text().trimmed().isEmpty()) return;
  if (controller_->note(note_->text())) note_->clear();
  showNotes();
}

/// Lists the newest note first.
void ControlPanel::showNotes() {
  notes_->clear();
  if (controller_ != nullptr) {
    for (const auto& note : controller_->notes()) {
      notes_->insertItem(
          0, note.when.toString(QStringLiteral("HH:mm:ss")) + QStringLiteral("  ") + note.text);
    }
  }
  notes_->setVisible(notes_->count() > 0);
}

/// Shows, for example, "P003" and "Orthopaedic surgeons · live · English".
void ControlPanel::showParticipant() {
  if (controller_ == nullptr) return;
  const auto& session = controller_->session();
  participantLabel_->setText(QString::fromStdString(session.participant()));
  const QStringList parts{
      cohortTitle(session.protocol().protocol, session.cohort()),
      deskText(nameOf(session.runMode())),
      nativeName(QString::fromStdString(session.language()))};
  cohort_->setText(parts.join(QStringLiteral(" · ")));
}

void ControlPanel::setController(SessionController* controller) {
  controller_ = controller;
  showNotes();
  refresh();
  if (controller_ != nullptr) note_->setFocus();
}

/// Whether the operator may do it now. What ends a session may be done in a running trial, too: it
/// stops the trial first (performWithReason()).
bool ControlPanel::mayDo(SessionEvent event) const {
  if (controller_ == nullptr) return false;
  const auto& session = controller_->session();
  if (!controller_->isTrialRunning()) return session.allows(event);
  constexpr std::array kEndings{
      SessionEvent::Withdrew, SessionEvent::WasRejected, SessionEvent::GaveUpOnDevice};
  return std::ranges::find(kEndings, event) != kEndings.end();
}

void ControlPanel::refresh() {
  showParticipant();
  state_->showState(controller_);
  const bool isOpen = controller_ != nullptr;
  const bool isRunning = isOpen && controller_->isTrialRunning();
  stop_->setEnabled(isRunning);
  for (const auto& choice : choices_) choice.button->setVisible(mayDo(choice.event));
  const bool isPaused = mayDo(SessionEvent::ResumedSession);
  const bool mayFinish = mayDo(SessionEvent::FinishedStep);
  const auto kind = mayFinish ? controller_->session().step().kind : StepKind::Reading;
  const bool isUnsaved = isOpen && controller_->isTrialUnsaved();
  saveTrial_->setVisible(isUnsaved);
  resume_->setVisible(isPaused);
  interviewDone_->setVisible(mayFinish && kind == StepKind::Interview);
  for (auto* button : {countCut_, uncountCut_})
    button->setVisible(mayFinish && kind == StepKind::Benchmark);
  const bool isInSteps =
      isPaused || mayDo(SessionEvent::PausedSession) || mayDo(SessionEvent::SkippedStep);
  now_->setVisible(isRunning || isUnsaved || isInSteps);
  now_->setText(
      isRunning ? tr("To repeat, skip or pause, STOP first or wait for the trial's end.")
                : tr("Now"));
  const bool mayEnd = mayDo(SessionEvent::Withdrew);
  ends_->setVisible(mayEnd);
  ends_->setText(
      isRunning ? tr("To end the session (stops the force first)") : tr("Ends the session"));
  note_->setEnabled(isOpen);
  handOver_->setEnabled(isOpen);
  consent_->setVisible(isOpen && !isRunning);
  close_->setVisible(isOpen && !isRunning);
  fitSteps();
  keepFocusOffButtons();
}

void ControlPanel::updateTrial() {
  if (controller_ != nullptr && controller_->isTrialRunning()) state_->showCount(*controller_);
}

/// A button that is hidden or disabled passes its focus to the next one, which may end the session.
/// Moves it elsewhere.
void ControlPanel::keepFocusOffButtons() {
  const auto* focused = window()->focusWidget();
  const bool isOnAButton = qobject_cast<const QPushButton*>(focused) != nullptr;
  if (isOnAButton && isAncestorOf(focused) && note_->isEnabled()) note_->setFocus();
}

}  // namespace study::gui
