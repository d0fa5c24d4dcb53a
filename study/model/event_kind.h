#pragma once

#include <string_view>

#include "study/model/session_state.h"
#include "study/model/trial_record.h"

namespace study {

/// What an event of the audit trail is about. Its name is stored and exported, and hashed with the
/// event: it never changes.
enum class EventKind {
  // A study
  MadeStudy,
  FrozeProtocol,
  AmendedProtocol,
  PublicExport,
  UnblindedExport,
  UnblindedReport,
  UnblindedResults,
  Exported,  ///< to which folder; an unblinded or public one also has an event of its own
  MadeBackup,
  RestoredCopy,     ///< an older copy took the study's place
  NotedIdentities,  ///< what identity.db has, where the trail did not know it
  SignedHead,       ///< a station vouches for all events before this one
  HeadNotSigned,    ///< the station's key could not be used
  Erased,           ///< names, answers or both of a participant
  CollectedStudy,   ///< a study was put together of what its stations sent
  ResealedTrail,    ///< the trail of an older format was sealed once, so that it can be erased from
  ExportedKey,      ///< the key of the conditions left the station, and why
  ImportedKey,      ///< another station, which signs this, has it now
  SetPassphrase,    ///< that opens the key
  DroppedKey,       ///< this station has the key no more
  TimeStamped,      ///< by an authority, for a head that was signed before
  SealedNames,      ///< names are behind a passphrase, or behind another one, and why
  CopiedForms,      ///< of the library, into a study that an older release made

  // What can happen to a session, in the order of SessionEvent
  FinishedStep,
  GaveConsent,
  DeclinedConsent,
  BeganTrial,
  FinishedTrial,
  BrokeOffTrial,
  RepeatedStep,
  SkippedStep,
  PausedSession,
  ResumedSession,
  FinishedSession,
  Withdrew,
  WasRejected,
  GaveUpOnDevice,

  // What else happens in it
  Enrolled,
  Resumed,   ///< by another run of the program
  TookOver,  ///< from a computer that is gone, with a reason
  ClockStepped,
  ChoseLanguage,
  Note,
  Answered,
  Retracted,

  // A trial
  SwitchedReamer,
  KeptTrace,
  Passivity,
  Torque,
  DeviceLink,
  DeviceFault,
  View,

  // What its safety functions did, in the order of SafetyKind
  SafetyTooFast,
  SafetyReleased,
  SafetyNoSample,
  SafetyMissedPeriods,
  SafetySoftStart,
  SafetySaturated,
  SafetySlewed,
  SafetyNotFinite,
  SafetyActive,
  SafetyDamped,
  SafetyTorqueSaturated,
  SafetyTorqueSlewed,
  SafetyTorqueActive,

  Unknown,  ///< a later release wrote it
};

/// "finished_trial", as it is stored; empty for Unknown.
std::string_view nameOf(EventKind kind) noexcept;

/// Unknown where no kind has this name.
EventKind eventKindNamed(std::string_view name) noexcept;

constexpr EventKind kindOf(SessionEvent event) noexcept {
  return static_cast<EventKind>(
      static_cast<int>(EventKind::FinishedStep) + static_cast<int>(event));
}
static_assert(kindOf(SessionEvent::GaveUpOnDevice) == EventKind::GaveUpOnDevice);

constexpr EventKind kindOf(SafetyKind kind) noexcept {
  return static_cast<EventKind>(
      static_cast<int>(EventKind::SafetyTooFast) + static_cast<int>(kind));
}
static_assert(kindOf(SafetyKind::TorqueActive) == EventKind::SafetyTorqueActive);

/// How the values of an event read in English, with their names in braces.
struct EventPattern {
  std::string_view english = {};  ///< empty: events of this kind have no named values
  std::string_view counted = {};  ///< the value that is one in …
  std::string_view ofOne = {};
};
EventPattern patternOf(EventKind kind) noexcept;

}  // namespace study
