#include "study/gui/operator/control_panel.h"

#include <QGridLayout>
#include <QInputDialog>
#include <QScrollArea>
#include <QVBoxLayout>

#include "study/gui/participant/participant_window.h"
#include "study/gui/session/session_controller.h"
#include "study/gui/widgets/labels.h"

namespace study::gui {

ControlPanel::ControlPanel(QWidget* parent)
    : QWidget(parent),
      who_(bodyLabel({}, this)),
      cohort_(quietLabel({}, this)),
      stop_(new QPushButton(tr("STOP: no force"), this)),
      resume_(new QPushButton(tr("Continue"), this)),
      interviewDone_(new QPushButton(tr("Finish the interview"), this)),
      handOver_(new QPushButton(tr("Hand over the screen…"), this)),
      consent_(new QPushButton(tr("Copy of the consent…"), this)),
      close_(new QPushButton(tr("Close this session"), this)),
      note_(new QLineEdit(this)),
      notes_(new QListWidget(this)) {
  who_->setProperty("role", QStringLiteral("heading"));
  who_->setObjectName(QStringLiteral("who"));
  stop_->setProperty("role", QStringLiteral("stop"));
  stop_->setToolTip(tr("Also Esc, Pause, F12, or a foot switch that types one of them"));
  resume_->setToolTip(tr("End the pause"));
  handOver_->setToolTip(tr("The participant's window covers the screen until your PIN"));
  notes_->setAccessibleName(tr("Notes of this session"));
  notes_->setFocusPolicy(Qt::NoFocus);
  notes_->setWordWrap(true);
  note_->setPlaceholderText(tr("Note, with the time; Enter saves it"));
  note_->setAccessibleName(tr("Note"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  layout->addWidget(who_);
  layout->addWidget(cohort_);
  layout->addWidget(stop_);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(makeButtons());
  layout->addWidget(scroll, 1);
  connectButtons();
  refresh();
}

QWidget* ControlPanel::makeButtons() {
  auto* inside = new QWidget(this);
  auto* layout = new QVBoxLayout(inside);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  auto* grid = new QGridLayout;
  grid->setSpacing(8);
  const std::vector<QPushButton*> buttons{
      add(tr("Repeat…"), SessionEvent::RepeatedStep, &SessionController::repeatStep),
      add(tr("Skip…"), SessionEvent::SkippedStep, &SessionController::skipStep),
      pause_ = add(tr("Pause…"), SessionEvent::PausedSession, &SessionController::pause),
      interviewDone_,
      add(tr("Participant withdraws…"), SessionEvent::Withdrew, &SessionController::withdraw),
      add(tr("Reject the session…"), SessionEvent::WasRejected, &SessionController::reject),
      add(tr("Give up on the device…"),
          SessionEvent::GaveUpOnDevice,
          &SessionController::giveUpOnDevice),
      consent_,
      handOver_,
      close_};
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    buttons[i]->setProperty("role", QStringLiteral("tool"));
    grid->addWidget(buttons[i], static_cast<int>(i / 2), static_cast<int>(i % 2));
  }
  resume_->setProperty("role", QStringLiteral("tool"));
  grid->addWidget(resume_, 1, 0);  // shares a place with "Pause…": one of them is enabled
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  layout->addLayout(grid);
  layout->addWidget(note_);
  constexpr int kTwoNotes = 76;  // [px]
  notes_->setMinimumHeight(kTwoNotes);
  layout->addWidget(notes_, 1);
  return inside;
}

void ControlPanel::connectButtons() {
  connect(stop_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->stop();
  });
  connect(resume_, &QPushButton::clicked, this, [this] {
    if (controller_ != nullptr) controller_->resume();
  });
  connect(interviewDone_, &QPushButton::clicked, this, &ControlPanel::interviewFinished);
  connect(note_, &QLineEdit::returnPressed, this, &ControlPanel::keepNote);
  connect(handOver_, &QPushButton::clicked, this, &ControlPanel::handOverRequested);
  connect(consent_, &QPushButton::clicked, this, &ControlPanel::consentCopyRequested);
  connect(close_, &QPushButton::clicked, this, &ControlPanel::closeSessionRequested);
}

QPushButton* ControlPanel::add(const QString& text, SessionEvent event, Perform action) {
  auto* button = new QPushButton(text, this);
  choices_.push_back({button, event});
  connect(button, &QPushButton::clicked, this, [this, action, text, event] {
    askAndDo(action, text, event);
  });
  return button;
}

void ControlPanel::askAndDo(Perform action, const QString& what, SessionEvent event) {
  if (controller_ == nullptr) return;
  const bool isEnd = event == SessionEvent::Withdrew || event == SessionEvent::WasRejected ||
                     event == SessionEvent::GaveUpOnDevice;
  const QString consequence = isEnd ? tr("This ends the session for good; what was answered is "
                                         "kept, and its place in the design is free again.\n\n")
                                    : QString();
  controller_->stop();  // no force while the operator types a reason
  bool isMeant = false;
  const QString reason = QInputDialog::getText(
      this,
      what,
      consequence + tr("Why? This goes into the record."),
      QLineEdit::Normal,
      {},
      &isMeant);
  if (isMeant && controller_ != nullptr) (controller_->*action)(reason);
}

void ControlPanel::keepNote() {
  if (controller_ == nullptr || note_->text().trimmed().isEmpty()) return;
  if (controller_->note(note_->text())) note_->clear();
  showNotes();
}

/// Lists the newest note first.
void ControlPanel::showNotes() {
  notes_->clear();
  if (controller_ == nullptr) return;
  for (const auto& note : controller_->notes()) {
    notes_->insertItem(
        0, note.when.toString(QStringLiteral("HH:mm:ss")) + QStringLiteral("  ") + note.text);
  }
}

/// Shows, for example, "P003" and "Orthopaedic surgeons · live · English".
void ControlPanel::showWho() {
  if (controller_ == nullptr) return;
  const auto& session = controller_->session();
  who_->setText(QString::fromStdString(session.participant()));
  const QStringList parts{
      cohortTitle(session.protocol().protocol, session.cohort()),
      asText(nameOf(session.runMode())),
      nativeName(QString::fromStdString(session.language()))};
  cohort_->setText(parts.join(QStringLiteral(" · ")));
}

void ControlPanel::follow(SessionController* controller) {
  controller_ = controller;
  showNotes();
  refresh();
}

void ControlPanel::refresh() {
  showWho();
  const bool isOpen = controller_ != nullptr;
  const bool isRunning = isOpen && controller_->isTrialRunning();
  stop_->setEnabled(isRunning);
  for (const auto& choice : choices_) {
    // During a trial only stopping and withdrawing are possible.
    const bool isAllowed = isOpen && controller_->session().allows(choice.event);
    choice.button->setEnabled(isAllowed && (!isRunning || choice.event == SessionEvent::Withdrew));
  }
  const bool isPaused = isOpen && controller_->session().allows(SessionEvent::ResumedSession);
  const bool isInterview = isOpen && !controller_->session().isOver() &&
                           controller_->session().step().kind == StepKind::Interview &&
                           controller_->session().allows(SessionEvent::FinishedStep);
  resume_->setVisible(isPaused);
  pause_->setVisible(!isPaused);
  interviewDone_->setEnabled(isInterview);
  note_->setEnabled(isOpen);
  handOver_->setEnabled(isOpen);
  consent_->setEnabled(isOpen && !isRunning);
  close_->setEnabled(isOpen && !isRunning);
}

}  // namespace study::gui
