// The names of events in the audit trail: they are stored and hashed.
#include "study/model/event_kind.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "study/storage/event_log.h"
#include "tests/study/made_study.h"

namespace study {
namespace event_kind_test {

/// Every kind, as it is stored since release 0.1; torques and taking over since 0.2.
constexpr auto kStored = std::to_array<std::pair<EventKind, std::string_view>>({
    {EventKind::MadeStudy, "made_study"},
    {EventKind::FrozeProtocol, "froze_protocol"},
    {EventKind::AmendedProtocol, "amended_protocol"},
    {EventKind::PublicExport, "public_export"},
    {EventKind::UnblindedExport, "unblinded_export"},
    {EventKind::UnblindedReport, "unblinded_report"},
    {EventKind::UnblindedResults, "unblinded_results"},
    {EventKind::Exported, "exported"},
    {EventKind::MadeBackup, "made_backup"},
    {EventKind::RestoredCopy, "restored_copy"},
    {EventKind::NotedIdentities, "noted_identities"},
    {EventKind::SignedHead, "signed_head"},
    {EventKind::HeadNotSigned, "head_not_signed"},
    {EventKind::Erased, "erased"},
    {EventKind::CollectedStudy, "collected_study"},
    {EventKind::ResealedTrail, "resealed_trail"},
    {EventKind::ExportedKey, "exported_key"},
    {EventKind::ImportedKey, "imported_key"},
    {EventKind::SetPassphrase, "set_passphrase"},
    {EventKind::DroppedKey, "dropped_key"},
    {EventKind::TimeStamped, "time_stamped"},
    {EventKind::SealedNames, "sealed_names"},
    {EventKind::CopiedForms, "copied_forms"},
    {EventKind::CopiedConsent, "copied_consent"},
    {EventKind::ShowedNames, "showed_names"},
    {kindOf(SessionEvent::FinishedStep), "finished_step"},
    {kindOf(SessionEvent::GaveConsent), "gave_consent"},
    {kindOf(SessionEvent::DeclinedConsent), "declined_consent"},
    {kindOf(SessionEvent::BeganTrial), "began_trial"},
    {kindOf(SessionEvent::FinishedTrial), "finished_trial"},
    {kindOf(SessionEvent::BrokeOffTrial), "broke_off_trial"},
    {kindOf(SessionEvent::RepeatedStep), "repeated_step"},
    {kindOf(SessionEvent::SkippedStep), "skipped_step"},
    {kindOf(SessionEvent::PausedSession), "paused_session"},
    {kindOf(SessionEvent::ResumedSession), "resumed_session"},
    {kindOf(SessionEvent::FinishedSession), "finished_session"},
    {kindOf(SessionEvent::Withdrew), "withdrew"},
    {kindOf(SessionEvent::WasRejected), "was_rejected"},
    {kindOf(SessionEvent::GaveUpOnDevice), "gave_up_on_device"},
    {EventKind::Enrolled, "enrolled"},
    {EventKind::Resumed, "resumed"},
    {EventKind::TookOver, "took_over"},
    {EventKind::ClockStepped, "clock_stepped"},
    {EventKind::ChoseLanguage, "chose_language"},
    {EventKind::ShowedForces, "showed_forces"},
    {EventKind::Note, "note"},
    {EventKind::Answered, "answered"},
    {EventKind::Retracted, "retracted"},
    {EventKind::KeptTrace, "kept_trace"},
    {EventKind::Passivity, "passivity"},
    {EventKind::Torque, "torque"},
    {EventKind::DeviceLink, "device_link"},
    {EventKind::DeviceFault, "device_fault"},
    {EventKind::SwitchedReamer, "switched_reamer"},
    {EventKind::View, "view"},
    {kindOf(SafetyKind::TooFast), "safety_too_fast"},
    {kindOf(SafetyKind::DeadManReleased), "safety_released"},
    {kindOf(SafetyKind::NoSample), "safety_no_sample"},
    {kindOf(SafetyKind::MissedPeriods), "safety_lost_beats"},
    {kindOf(SafetyKind::SoftStart), "safety_soft_start"},
    {kindOf(SafetyKind::Saturated), "safety_saturated"},
    {kindOf(SafetyKind::Slewed), "safety_slewed"},
    {kindOf(SafetyKind::NotFinite), "safety_not_finite"},
    {kindOf(SafetyKind::Active), "safety_active"},
    {kindOf(SafetyKind::Damped), "safety_damped"},
    {kindOf(SafetyKind::TorqueSaturated), "safety_torque_saturated"},
    {kindOf(SafetyKind::TorqueSlewed), "safety_torque_slewed"},
    {kindOf(SafetyKind::TorqueActive), "safety_torque_active"},
});

TEST(EventKind, HasTheNameThatIsStored) {
  EXPECT_EQ(kStored.size(), static_cast<std::size_t>(EventKind::Unknown));
  for (const auto& [kind, name] : kStored) {
    EXPECT_EQ(nameOf(kind), name);
    EXPECT_EQ(eventKindNamed(name), kind) << name;
  }
  EXPECT_EQ(eventKindNamed("Answered"), EventKind::Unknown);
  EXPECT_EQ(eventKindNamed(""), EventKind::Unknown);
}

TEST(EventKind, OfALaterReleaseKeepsItsNameAndWords) {
  tests::MadeStudy study{tests::libraryProtocol("punch-face-validity.json"), 1};
  const storage::Event later{.detail = "{\"a\":1}", .unknownName = "later_kind"};
  study->note(later);
  const auto event = study->events().read().rbegin()[1];  // the last one is its signature
  EXPECT_EQ(event.kind, EventKind::Unknown);
  EXPECT_EQ(event.name(), "later_kind");
  EXPECT_EQ(storage::describe(event), later.detail);
  EXPECT_FALSE(study->events().firstBreak());
}

}  // namespace event_kind_test
}  // namespace study
