#include "study/gui/control_panel.h"

#include <QGridLayout>
#include <QInputDialog>
#include <QVBoxLayout>

#include "study/gui/session_controller.h"

namespace study::gui {

ControlPanel::ControlPanel(QWidget* parent)
    : QWidget(parent),
      stop_(new QPushButton(tr("STOP: no force"), this)),
      resume_(new QPushButton(tr("Continue after the pause"), this)),
      interviewDone_(new QPushButton(tr("Finish the interview"), this)),
      handOver_(new QPushButton(tr("Hand over the screen…"), this)),
      consent_(new QPushButton(tr("Copy of the consent…"), this)),
      close_(new QPushButton(tr("Close this session"), this)),
      note_(new QLineEdit(this)),
      notes_(new QListWidget(this)) {
  stop_->setProperty("role", QStringLiteral("stop"));
  stop_->setToolTip(tr("Also Esc, Pause, F12, or a foot switch that types one of them"));
  handOver_->setToolTip(tr("The participant's window covers the screen until your PIN"));
  notes_->setAccessibleName(tr("Notes of this session"));
  notes_->setMaximumHeight(76);
  notes_->setFocusPolicy(Qt::NoFocus);
  note_->setPlaceholderText(tr("Note, with the time; Enter saves it"));
  note_->setAccessibleName(tr("Note"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(stop_);
  auto* grid = new QGridLayout;
  grid->setSpacing(8);
  const std::vector<QPushButton*> buttons{
      add(tr("Repeat…"), SessionEvent::RepeatedStep, &SessionController::repeatStep),
      add(tr("Skip…"), SessionEvent::SkippedStep, &SessionController::skipStep),
      add(tr("Pause…"), SessionEvent::PausedSession, &SessionController::pause),
      resume_,
      add(tr("Participant withdraws…"), SessionEvent::Withdrew, &SessionController::withdraw),
      add(tr("Reject the session…"), SessionEvent::WasRejected, &SessionController::reject),
      add(tr("Give up on the device…"),
          SessionEvent::GaveUpOnDevice,
          &SessionController::giveUpOnDevice),
      interviewDone_,
      handOver_,
      consent_};
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    grid->addWidget(buttons[i], static_cast<int>(i / 2), static_cast<int>(i % 2));
  }
  layout->addLayout(grid);
  layout->addWidget(note_);
  layout->addWidget(notes_);
  layout->addWidget(close_);
  for (auto* button : findChildren<QPushButton*>()) {
    if (button != stop_) button->setProperty("role", QStringLiteral("tool"));
  }

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
  refresh();
}

QPushButton* ControlPanel::add(const QString& text, SessionEvent event, Perform action) {
  auto* button = new QPushButton(text, this);
  choices_.push_back({button, event});
  connect(button, &QPushButton::clicked, this, [this, action, text] { askAndDo(action, text); });
  return button;
}

void ControlPanel::askAndDo(Perform action, const QString& what) {
  if (controller_ == nullptr) return;
  controller_->stop();  // no force while somebody types why
  bool isMeant = false;
  const QString reason = QInputDialog::getText(
      this, what, tr("Why? This goes into the record."), QLineEdit::Normal, {}, &isMeant);
  if (isMeant && controller_ != nullptr) (controller_->*action)(reason);
}

void ControlPanel::keepNote() {
  if (controller_ == nullptr || note_->text().trimmed().isEmpty()) return;
  if (controller_->note(note_->text())) note_->clear();
  showNotes();
}

/// The newest first.
void ControlPanel::showNotes() {
  notes_->clear();
  if (controller_ == nullptr) return;
  for (const auto& note : controller_->notes()) {
    notes_->insertItem(
        0, note.when.toString(QStringLiteral("HH:mm:ss")) + QStringLiteral("  ") + note.text);
  }
}

void ControlPanel::follow(SessionController* controller) {
  controller_ = controller;
  showNotes();
  refresh();
}

void ControlPanel::refresh() {
  const bool isOpen = controller_ != nullptr;
  const bool isRunning = isOpen && controller_->isTrialRunning();
  stop_->setEnabled(isRunning);
  for (const auto& choice : choices_) {
    // While something is felt there is one button only, and withdrawing.
    const bool isAllowed = isOpen && controller_->session().allows(choice.event);
    choice.button->setEnabled(isAllowed && (!isRunning || choice.event == SessionEvent::Withdrew));
  }
  const bool isPaused = isOpen && controller_->session().allows(SessionEvent::ResumedSession);
  const bool isInterview = isOpen && !controller_->session().isOver() &&
                           controller_->session().step().kind == StepKind::Interview &&
                           controller_->session().allows(SessionEvent::FinishedStep);
  resume_->setEnabled(isPaused);
  interviewDone_->setEnabled(isInterview);
  note_->setEnabled(isOpen);
  handOver_->setEnabled(isOpen);
  consent_->setEnabled(isOpen && !isRunning);
  close_->setEnabled(isOpen && !isRunning);
}

}  // namespace study::gui
