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
  NotedIdentities,  ///< rows of identity.db of which the trail had no event
  SignedHead,       ///< a station vouches for all events before this one
  HeadNotSigned,    ///< the station's key could not be used
  Erased,           ///< names, answers or both of a participant
  CollectedStudy,   ///< the study was assembled from the data of its stations
  ResealedTrail,  ///< the trail of an older release was sealed, so that participants can be erased
                  ///< from it
  ExportedKey,    ///< the study's key was exported from the station, with the reason
  ImportedKey,    ///< another station, which signs this event, received the key
  SetPassphrase,  ///< a passphrase for the study's key was set
  DroppedKey,     ///< this station deleted its copy of the key
  TimeStamped,    ///< a time-stamp authority stamped a head that was signed earlier
  SealedNames,    ///< names were sealed with a passphrase, or with a new one; with the reason
  CopiedForms,    ///< forms of the library were copied into a study of an older release

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

  // Other events of a session
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

  // What the safety functions of a trial did, in the order of SafetyKind
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

/// The kind with that stored name; Unknown if there is none.
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

/// Patterns that describe the values of an event in English; names of values are in braces.
struct EventPattern {
  std::string_view english = {};  ///< empty: events of this kind have no named values
  std::string_view counted = {};  ///< name of a value; if it is 1, ofOne replaces english
  std::string_view ofOne = {};    ///< pattern for the singular
};
EventPattern patternOf(EventKind kind) noexcept;

}  // namespace study
