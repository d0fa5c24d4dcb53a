#pragma once

#include <string_view>

#include "study/model/session_state.h"
#include "study/model/trial_record.h"

namespace study {

/// What an event of the audit trail is about. The name of a kind is stored, exported, and part of
/// the event's hash, so it never changes.
enum class EventKind {
  // Events of a study
  MadeStudy,
  FrozeProtocol,
  AmendedProtocol,
  PublicExport,
  UnblindedExport,
  UnblindedReport,
  UnblindedResults,
  Exported,  ///< the study was exported to a folder, or a report or its figures were written; an
             ///< unblinded or public one has a second event
  MadeBackup,
  RestoredCopy,     ///< an older copy of the study, such as a backup, replaced it
  NotedIdentities,  ///< fingerprints of rows of identity.db that the trail did not have yet
  SignedHead,       ///< a station's signature of all events before this one
  HeadNotSigned,    ///< the trail was not signed, because the station's key or list could not be
                    ///< used, or the trail lacks heads in the list
  Erased,           ///< names, answers or both of a participant were erased
  CollectedStudy,   ///< the study was assembled from the data of its stations
  ResealedTrail,  ///< the trail of an older release was sealed, so that participants can be erased
                  ///< from it
  ExportedKey,    ///< the study's key was exported to a file, with the reason
  ImportedKey,    ///< the study's key was imported at another station, which signs this event
  SetPassphrase,  ///< a passphrase for the study's key was set
  DroppedKey,     ///< this station deleted its copy of the key
  TimeStamped,    ///< a time-stamp authority stamped an earlier signature
  SealedNames,    ///< names were sealed with a passphrase, or with a new one; with the reason
  CopiedForms,    ///< forms of the library were copied into a study of an older release
  CopiedConsent,  ///< a copy of a participant's consent form was written
  ShowedNames,    ///< somebody was shown the names that participants gave

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
  Resumed,       ///< a program continued the session
  TookOver,      ///< the session was taken over from another computer, with the reason
  ClockStepped,  ///< the wall clock was changed during the session
  ChoseLanguage,
  ShowedForces,  ///< the window showed the operator the forces of a blinded session, or hid them
                 ///< again
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

  Unknown,  ///< a kind of event that this release does not know
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
  std::string_view english = {};       ///< empty: events of this kind have no named values
  std::string_view countedValue = {};  ///< name of a value; if it is 1, singular replaces english
  std::string_view singular = {};      ///< pattern for the singular
};
EventPattern patternOf(EventKind kind) noexcept;

}  // namespace study
