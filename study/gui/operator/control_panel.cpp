#include "study/gui/operator/control_panel.h"

#include <QVBoxLayout>

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
  return {
      QString::number(step + 1),
      describe(session.plan()[static_cast<std::size_t>(step)], session.protocol().protocol.labels)};
}

}  // namespace

ControlPanel::ControlPanel(QWidget* parent)
    : QWidget(parent),
      participantLabel_(headingLabel({}, this)),
      cohort_(quietLabel({}, this)),
      stop_(new QPushButton(tr("STOP the force"), this)),
      resume_(new QPushButton(tr("Continue"), this)),
      interviewDone_(new QPushButton(tr("Interview done"), this)),
      countCut_(new QPushButton(tr("Count a cut (F9)"), this)),
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
  auto* scroll = scrolled(makeButtons(), this);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  layout->addWidget(scroll, 1);
  connectButtons();
  refresh();
}

QWidget* ControlPanel::makeButtons() {
  auto* inside = new QWidget(this);
  auto* layout = withoutMargins<QVBoxLayout>(inside, 8);
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
  auto* now = addGroup(*layout, tr("Now"), {{repeat, skip}, {pause_, interviewDone_}});
  resume_->setProperty("role", QStringLiteral("tool"));
  now->insertWidget(0, resume_, 1);  // in place of "Pause…": one of them is shown
  countCut_->setProperty("role", QStringLiteral("tool"));
  countCut_->setToolTip(tr("The participant has made a cut with the real instrument"));
  countCut_->setFocusPolicy(Qt::TabFocus);  // as for the button that it replaces
  now->addWidget(countCut_, 1);
  layout->addWidget(note_);
  addGroup(*layout, tr("Session"), {{handOver_, consent_, close_}});
  endingButtons_ = {
      add(tr("Withdrawal…"),
          SessionEvent::Withdrew,
          MessageTopic::Withdrawal,
          &SessionController::withdraw,
          tr("The participant withdraws: the session ends")),
      add(tr("Reject…"),
          SessionEvent::WasRejected,
          MessageTopic::Rejection,
          &SessionController::reject,
          tr("This session does not count: it ends")),
      add(tr("Device failed…"),
          SessionEvent::GaveUpOnDevice,
          MessageTopic::DeviceFailure,
          &SessionController::giveUpOnDevice,
          tr("The device cannot go on: the session ends"))};
  addGroup(*layout, tr("Ends the session"), {endingButtons_});
  constexpr int kTwoNotes = 76;  // [px]
  notes_->setMinimumHeight(kTwoNotes);
  layout->addWidget(notes_, 2);
  layout->addStretch(1);
  return inside;
}

/// A heading, and buttons row by row below it.
/// @return the last row.
QHBoxLayout* ControlPanel::addGroup(
    QVBoxLayout& layout, const QString& title, const std::vector<std::vector<QPushButton*>>& rows) {
  auto* heading = quietLabel(title, this);
  if (nowHeading_ == nullptr) nowHeading_ = heading;  // of the first group
  layout.addWidget(heading);
  QHBoxLayout* line = nullptr;
  for (const auto& row : rows) {
    line = new QHBoxLayout;
    line->setSpacing(8);
    layout.addLayout(line);
    for (auto* button : row) {
      button->setProperty("role", QStringLiteral("tool"));
      button->setAccessibleDescription(title);
      // A click does not move the focus, so that a space typed later presses no button.
      button->setFocusPolicy(Qt::TabFocus);
      line->addWidget(button, 1);
    }
  }
  return line;
}

void ControlPanel::connectButtons() {
  connect(stop_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->stop();
  });
  connect(resume_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->resume();
  });
  connect(interviewDone_, &QPushButton::clicked, this, &ControlPanel::interviewFinished);
  connect(countCut_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->countBenchmarkCut();
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
  choices_.push_back({button, event, help});
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

void ControlPanel::refresh() {
  showParticipant();
  const bool isOpen = controller_ != nullptr;
  const bool isRunning = isOpen && controller_->isTrialRunning();
  stop_->setEnabled(isRunning);
  nowHeading_->setText(isRunning ? tr("Possible once this trial has ended:") : tr("Now"));
  for (const auto& choice : choices_) {
    // During a trial only stopping and withdrawing are possible.
    const bool isAllowed = isOpen && controller_->session().allows(choice.event);
    const bool isEnabled = isAllowed && (!isRunning || choice.event == SessionEvent::Withdrew);
    choice.button->setEnabled(isEnabled);
    choice.button->setToolTip(isEnabled || !isOpen ? choice.help : whyNot(choice.event, isRunning));
  }
  const bool isPaused = isOpen && controller_->session().allows(SessionEvent::ResumedSession);
  const bool isInterview = isOpen && !controller_->session().isOver() &&
                           controller_->session().step().kind == StepKind::Interview &&
                           controller_->session().allows(SessionEvent::FinishedStep);
  resume_->setVisible(isPaused);
  pause_->setVisible(!isPaused);
  const bool isBenchmark = isOpen && !controller_->session().isOver() &&
                           controller_->session().step().kind == StepKind::Benchmark &&
                           controller_->session().allows(SessionEvent::FinishedStep);
  interviewDone_->setEnabled(isInterview);
  interviewDone_->setVisible(!isBenchmark);
  countCut_->setVisible(isBenchmark);
  note_->setEnabled(isOpen);
  handOver_->setEnabled(isOpen);
  consent_->setEnabled(isOpen && !isRunning);
  close_->setEnabled(isOpen && !isRunning);
  keepFocusOffButtons();
}

/// Why @p event is not possible now.
QString ControlPanel::whyNot(SessionEvent event, bool isRunning) {
  if (isRunning) return tr("Not while a trial is running");
  if (event == SessionEvent::GaveUpOnDevice)
    return tr("Only before a trial, or after one broke off");
  if (event == SessionEvent::SkippedStep || event == SessionEvent::RepeatedStep)
    return tr("Not possible in this step");
  return tr("Not possible in this state of the session");
}

/// A disabled button passes its focus to the next one, which may end the session. Moves it
/// elsewhere.
void ControlPanel::keepFocusOffButtons() {
  const auto* focused = window()->focusWidget();
  const bool isOnAButton = qobject_cast<const QPushButton*>(focused) != nullptr;
  if (isOnAButton && isAncestorOf(focused) && note_->isEnabled()) note_->setFocus();
}

}  // namespace study::gui
