#pragma once

#include <span>

namespace study::gui {

/// What a message or question in the windows is about. Each has a row in messages().
enum class MessageTopic {
  // Failures. The error says why, and what to do.
  BackupNotNoted,
  BackupNotSaved,
  ConsentCopyNotSaved,
  DataNotExported,
  DevicesNotChecked,
  DocumentNotMade,
  FileNotOpened,
  FileNotShown,
  KeyNotRead,
  KeyNotSaved,
  KeyNotTaken,
  NamesNotSealed,
  OwnProtocolNotSaved,
  ParticipantNotErased,
  ParticipantsNotListed,
  PlanNotComputed,
  PreviewNotShown,
  ProtocolNotChanged,
  ReportNotWritten,
  SessionNotBegun,
  SessionNotContinued,
  SessionsNotListed,
  SimulationNotFinished,
  StatisticsNotComputed,
  StepNotDone,
  StudyNotCreated,
  StudyNotOpened,
  StudyNotVerified,
  SystemNotChecked,
  TextsNotChanged,
  TableNotSaved,
  TextsNotSaved,
  VirtualPunchNotStarted,
  // Information and warnings for the operator.
  FileSaved,
  LiveSessionHasBlanks,
  TrialIsRunning,
  // Questions that are answered with a button.
  BoneBesideParticipant,
  CloseWithLoss,
  DiscardTexts,
  GoOnVirtually,
  LiveSessionInOlderCopy,
  PilotSessionHasBlanks,
  ShowForces,
  TextsChangeMeaning,
  // Questions with a text to enter or a choice to make.
  DeviceFailure,
  NamesPassphrase,
  OwnTitle,
  PauseSession,
  Rejection,
  RepeatStep,
  RepeatTrial,
  RestoredBackup,
  SkipStep,
  SkipTrial,
  StudyPassphrase,
  TakeOver,
  WhichProtocol,
  Withdrawal,
};

/// The words of a message or question, in English; %1, %2, … are replaced by arguments.
struct MessageRow {
  enum class Kind { Failure, Warning, Information, Question };
  enum class Field { None, Text, NeededText, Passphrase, Choice };

  MessageTopic topic{};
  Kind kind = Kind::Failure;
  const char* title = "";     ///< of the window: names the topic
  const char* headline = "";  ///< what happened, or what is asked
  const char* data = "";      ///< what it means for the data: what is saved, and what is not
  const char* advice = "";    ///< what to do; empty where an error says it
  const char* safe = "Close";
  const char* action = "";  ///< the verb of what is asked; empty: nothing is asked
  Field field = Field::None;
  const char* label = "";    ///< of the field
  const char* missing = "";  ///< why the action cannot be chosen while a needed text is empty
};

/// All messages and questions of the windows, one row for each MessageTopic, in its order.
std::span<const MessageRow> messages() noexcept;

const MessageRow& messageAbout(MessageTopic topic) noexcept;

}  // namespace study::gui
