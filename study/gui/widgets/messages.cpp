#include "study/gui/widgets/messages.h"

#include <array>
#include <cstddef>

namespace study::gui {
namespace {

using enum MessageTopic;
using Kind = MessageRow::Kind;
using Field = MessageRow::Field;

constexpr const char* kStudyUnchanged = "Nothing in the study was changed.";
constexpr const char* kReasonIsKept = "The reason goes into the record of the session.";
constexpr const char* kEndsForGood =
    "This ends the session for good. What was answered is kept, and its place in the design is "
    "free again.";

constexpr MessageRow failure(
    MessageTopic topic, const char* title, const char* headline, const char* data) {
  return {
      .topic = topic, .kind = Kind::Failure, .title = title, .headline = headline, .data = data};
}

constexpr MessageRow reason(
    MessageTopic topic,
    const char* title,
    const char* headline,
    const char* data,
    const char* action,
    Field field = Field::Text) {
  return {
      .topic = topic,
      .kind = Kind::Question,
      .title = title,
      .headline = headline,
      .data = data,
      .advice = kReasonIsKept,
      .safe = "Go on with the session",
      .action = action,
      .field = field,
      .label = "Reason",
      .missing = "Give a reason."};
}

constexpr auto kMessages = std::to_array<MessageRow>({
    failure(
        BackupNotNoted,
        "Restored backup",
        "The restored backup was not recorded.",
        kStudyUnchanged),
    failure(
        BackupNotSaved,
        "Back up a study",
        "The backup was not completed.",
        "The study itself was not changed. Do not rely on a backup that was begun here."),
    failure(
        ConsentCopyNotSaved,
        "Copy of the consent",
        "The copy was not saved.",
        "The consent itself is kept in the study."),
    failure(
        DataNotExported,
        "Export data",
        "The data were not exported.",
        "The study itself was not changed. Files that were begun may be incomplete."),
    failure(
        DevicesNotChecked,
        "Devices",
        "The check of the devices did not finish.",
        "No data are affected."),
    failure(
        DocumentNotMade,
        "Measurements",
        "The file was not made.",
        "The files that were read were not changed."),
    failure(
        FileNotOpened,
        "Open",
        "The desktop has no program that opens it.",
        "Nothing is lost: %1 is saved."),
    failure(FileNotShown, "Bone or knee", "The file cannot be shown.", "The file was not changed."),
    failure(KeyNotRead, "Key", "The state of the key could not be read.", kStudyUnchanged),
    failure(KeyNotSaved, "Key", "The key was not saved.", "The study keeps its key as before."),
    failure(
        KeyNotTaken,
        "Key",
        "The key was not imported.",
        "This account still does not have the key of the study. The study was not changed."),
    failure(
        NamesNotSealed,
        "Key",
        "The passphrase of the names was not set.",
        "The names are kept as before."),
    failure(
        OwnProtocolNotSaved,
        "Save as a protocol of your own",
        "The protocol was not saved.",
        "The protocol that it was made from was not changed."),
    failure(
        ParticipantNotErased,
        "Erase a participant",
        "The erasure did not finish.",
        "Data of the participant may still be there, or some of them may be erased. Verify the "
        "study, and erase again."),
    failure(
        ParticipantsNotListed,
        "Erase a participant",
        "The participants could not be listed.",
        "Nothing was erased."),
    failure(PlanNotComputed, "Plan", "The plan was not computed.", kStudyUnchanged),
    failure(
        PreviewNotShown,
        "Preview as participant",
        "The page could not be shown.",
        "A preview saves nothing, and the study was not changed."),
    failure(
        ProtocolNotChanged,
        "Change the protocol",
        "The protocol was not changed.",
        "New sessions use the same protocol as before."),
    failure(ReportNotWritten, "Write a report", "The report was not written.", kStudyUnchanged),
    failure(
        SessionNotBegun,
        "New participant",
        "The session did not begin.",
        "What was saved earlier is kept."),
    failure(
        SessionNotContinued,
        "Continue session",
        "The session was not continued.",
        "What was saved in it is kept."),
    failure(SessionsNotListed, "Sessions", "The sessions could not be listed.", kStudyUnchanged),
    failure(
        SimulationNotFinished,
        "Simulate participants",
        "The simulation did not finish.",
        "Sessions that were simulated until then are kept. The data of people are not affected."),
    failure(
        StatisticsNotComputed,
        "Statistics",
        "The statistics were not computed.",
        "The answers in the study were not changed."),
    failure(
        StepNotDone,
        "Session",
        "The last step was not carried out.",
        "What was saved before is kept. Answers that could not be saved are still on the page."),
    failure(StudyNotCreated, "New study", "The study was not created.", "No data were recorded."),
    failure(StudyNotOpened, "Open a study", "The study was not opened.", kStudyUnchanged),
    failure(
        StudyNotVerified,
        "Verify a study",
        "The verification did not finish.",
        "It says nothing about the data yet. The study was not changed."),
    failure(
        SystemNotChecked,
        "System check",
        "The system check did not finish.",
        "No data are affected."),
    failure(
        TextsNotChanged,
        "Fill in the texts",
        "The texts were not changed.",
        "New sessions use the same texts as before."),
    failure(
        TableNotSaved, "Save the table", "The table was not saved.", "The study was not changed."),
    failure(
        TextsNotSaved,
        "Fill in the texts",
        "The texts were not saved.",
        "The file of the protocol is as it was."),
    failure(
        VirtualPunchNotStarted,
        "Tour",
        "The virtual punch did not start.",
        "The tour saves nothing, and no study is affected."),

    {.topic = FileSaved,
     .kind = Kind::Information,
     .title = "Saved",
     .headline = "The file was saved.",
     .data = "It is at %1."},
    {.topic = LiveSessionHasBlanks,
     .kind = Kind::Warning,
     .title = "Texts with blanks",
     .headline = "A live session cannot begin: the texts still have blanks (%1).",
     .data = "No participant was enrolled. The participant would read the brackets:",
     .advice =
         "Close this study, and choose “Fill in the texts…” on the home page. To try the study "
         "first, choose the run mode “pilot”."},
    {.topic = TrialIsRunning,
     .kind = Kind::Warning,
     .title = "A trial is running",
     .headline = "The window cannot be closed while a trial is running.",
     .data = "The trial goes on, and is being recorded.",
     .advice = "Stop the trial first (STOP, or Esc); then close the window.",
     .safe = "Go on with the trial"},

    {.topic = BoneBesideParticipant,
     .kind = Kind::Question,
     .title = "Bone in colours",
     .headline = "Show the bone where the participant can see it?",
     .data = "The participant's window is on this screen: the participant would see how hard this "
             "alternative is, and the answers would no longer be blind.",
     .advice = "Move this window to another screen first.",
     .safe = "Keep it hidden",
     .action = "Show the bone"},
    {.topic = CloseWithLoss,
     .kind = Kind::Question,
     .title = "Close session",
     .headline = "Close the session although something could not be saved?",
     .data = "What was written in this step is not saved, and would be lost. Everything before it "
             "is saved.",
     .advice = "Go on, remove the cause, and close the session again.",
     .safe = "Go on with the session",
     .action = "Close and lose it"},
    {.topic = DiscardTexts,
     .kind = Kind::Question,
     .title = "Fill in the texts",
     .headline = "Discard what was typed?",
     .data = "Nothing of it was saved. The protocol keeps its texts as they are.",
     .safe = "Go on filling in",
     .action = "Discard it"},
    {.topic = GoOnVirtually,
     .kind = Kind::Question,
     .title = "Continue session",
     .headline = "Go on with virtual devices?",
     .data =
         "Until now this session was felt on: %1. Now the devices are virtual: nothing is felt, "
         "and the participant's mouse or space bar is the hand.",
     .advice = "To go on with the instrument, end the program, and start it with the device file "
               "(--devices FILE).",
     .safe = "Do not go on",
     .action = "Go on with virtual devices"},
    {.topic = LiveSessionInOlderCopy,
     .kind = Kind::Question,
     .title = "Older copy",
     .headline = "Begin a live session although this is an older copy of the study?",
     .data = "This computer has seen later events of the study than this folder has. A session "
             "that begins here is missing in the study itself.",
     .advice = "Close it and open the study itself. If this backup is to take the study's place, "
               "choose “Verify…” and record that it was put back on purpose.",
     .safe = "Do not begin",
     .action = "Begin the session"},
    {.topic = PilotSessionHasBlanks,
     .kind = Kind::Question,
     .title = "Texts with blanks",
     .headline = "Begin the pilot although the texts still have blanks (%1)?",
     .data = "A pilot does not count. The blanks are marked on the pages:",
     .advice = "For live sessions, choose “Fill in the texts…” on the home page first.",
     .safe = "Do not begin",
     .action = "Begin the pilot"},

    {.topic = ShowForces,
     .kind = Kind::Question,
     .title = "Force curves",
     .headline = "Show the forces in this session?",
     .data = "Conditions differ in their forces: who sees the curves can tell which alternative is "
             "which. It is recorded that they were shown, and the report says it.",
     .advice = "Show them only where the session cannot go on otherwise, as after a fault.",
     .safe = "Keep them hidden",
     .action = "Show the forces"},
    {.topic = TextsChangeMeaning,
     .kind = Kind::Question,
     .title = "Fill in the texts",
     .headline = "Save the texts, although answers then mean something else?",
     .data = "What was answered or felt so far means something else in this version:",
     .advice = "Results will say so. To keep both apart, make a new study.",
     .safe = "Go on filling in",
     .action = "Save the texts"},

    reason(
        DeviceFailure,
        "Device failed",
        "End the session because the device failed?",
        kEndsForGood,
        "End the session"),
    {.topic = NamesPassphrase,
     .kind = Kind::Question,
     .title = "Sealed names",
     .headline = "What is the passphrase of the names?",
     .data = "The names of participants are sealed. Without the passphrase no session can begin or "
             "continue.",
     .advice = "The passphrase is not saved; it is valid until the program ends.",
     .safe = "Open without names",
     .action = "Unlock the names",
     .field = Field::Passphrase,
     .label = "Passphrase"},
    {.topic = OwnTitle,
     .kind = Kind::Question,
     .title = "Save as a protocol of your own",
     .headline = "What is the title of your study?",
     .data = "The protocol becomes a file of yours. The one that it is made from is not changed.",
     .safe = "Do not save",
     .action = "Choose the file…",
     .field = Field::NeededText,
     .label = "Title",
     .missing = "Give a title."},
    reason(
        PauseSession,
        "Pause",
        "Pause the session?",
        "Everything up to now is saved. The participant waits until the pause is ended.",
        "Pause the session"),
    reason(
        Rejection,
        "Reject",
        "End the session because it does not count?",
        kEndsForGood,
        "End the session",
        Field::NeededText),
    reason(
        RepeatStep,
        "Repeat",
        "Repeat from step %1 (%2)?",
        "What was answered and measured from that step on is kept as an earlier attempt, and no "
        "longer counts.",
        "Repeat from that step",
        Field::NeededText),
    reason(
        RepeatTrial,
        "Repeat",
        "Repeat the trial from its start?",
        "What was felt so far is kept as broken off.",
        "Repeat the trial",
        Field::NeededText),
    {.topic = RestoredBackup,
     .kind = Kind::Question,
     .title = "Restored backup",
     .headline = "Was a backup put back on purpose?",
     .data = "What this station signed after the backup is given up for good.",
     .advice = "The reason goes into the audit trail for good.",
     .safe = "Change nothing",
     .action = "Record the backup",
     .field = Field::NeededText,
     .label = "Reason",
     .missing = "Give a reason."},
    reason(
        SkipStep,
        "Skip",
        "Skip this step?",
        "The step stays without the answers that are still missing.",
        "Skip the step",
        Field::NeededText),
    reason(
        SkipTrial,
        "Skip",
        "Skip the trial and the questions about it?",
        "The trial does not count, and the questions about it stay without answers.",
        "Skip the trial",
        Field::NeededText),
    {.topic = StudyPassphrase,
     .kind = Kind::Question,
     .title = "Sealed study",
     .headline = "What is the passphrase of the study?",
     .data = "The conditions of this study are sealed, and this account does not have the key.",
     .advice = "The key is not saved; it is valid until the program ends.",
     .safe = "Open without the key",
     .action = "Unlock the study",
     .field = Field::Passphrase,
     .label = "Passphrase"},
    {.topic = TakeOver,
     .kind = Kind::Question,
     .title = "Take over session",
     .headline = "Take the session over from %1?",
     .data = "It last stored something at %2. From now on nothing can be saved on %1, which cannot "
             "be seen from here.",
     .advice = "The reason is recorded.",
     .safe = "Leave it there",
     .action = "Take it over",
     .field = Field::NeededText,
     .label = "Reason",
     .missing = "Give a reason."},
    {.topic = WhichProtocol,
     .kind = Kind::Question,
     .title = "Check protocol",
     .headline = "Which protocol is to be checked?",
     .data = "The check changes no file and no study.",
     .safe = "Do not check",
     .action = "Check the protocol",
     .field = Field::Choice,
     .label = "Protocol"},
    reason(
        Withdrawal,
        "Withdrawal",
        "Does the participant withdraw?",
        kEndsForGood,
        "End the session"),
});

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kMessages.size(); ++i) {
    if (static_cast<std::size_t>(kMessages[i].topic) != i) return false;
  }
  return true;
}
static_assert(isInOrder(), "messageAbout() takes the row at the place of its topic");
static_assert(kMessages.back().topic == Withdrawal, "every topic has a row");

}  // namespace

std::span<const MessageRow> messages() noexcept {
  return kMessages;
}

const MessageRow& messageAbout(MessageTopic topic) noexcept {
  return kMessages[static_cast<std::size_t>(topic)];
}

}  // namespace study::gui
