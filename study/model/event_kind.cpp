#include "study/model/event_kind.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace study {
namespace {

constexpr std::size_t kKnownKinds = static_cast<std::size_t>(EventKind::Unknown);

struct EventFacts {
  std::string_view name;
  EventPattern pattern = {};
};

constexpr EventPattern kSafety{
    "{times} times, {duration_s:.3f} s in all", "times", "{times} time, {duration_s:.3f} s in all"};

/// One row for each EventKind but Unknown, in the order of the enumerators.
constexpr std::array<EventFacts, kKnownKinds> kFacts{
    EventFacts{"made_study", {"{study}"}},
    EventFacts{"froze_protocol"},
    EventFacts{"amended_protocol", {"version {version}: {reason}"}},
    EventFacts{"public_export", {"k = {k}, {people} people, smallest class {smallest}"}},
    EventFacts{"unblinded_export"},
    EventFacts{"unblinded_report"},
    EventFacts{"unblinded_results"},
    EventFacts{"exported", {"{run_mode} sessions, {how}, to {folder}"}},
    EventFacts{"made_backup", {"to {folder}"}},
    EventFacts{"restored_copy", {"{reason}"}},
    EventFacts{"noted_identities", {"{rows}"}},
    EventFacts{
        "signed_head", {"{events} events, hash {hash}, for {purpose}, by the station {key}"}},
    EventFacts{"head_not_signed"},
    EventFacts{"erased", {"{participant} ({level}): {reason}"}},
    EventFacts{
        "collected_study", {"{sessions} sessions of {stations} stations; {trails}: {reason}"}},
    EventFacts{"resealed_trail", {"{events} events until then, the last one {head}: {reason}"}},
    EventFacts{"exported_key"},
    EventFacts{"imported_key"},
    EventFacts{"set_passphrase"},
    EventFacts{"dropped_key"},
    EventFacts{"time_stamped", {"on {utc}, by an authority"}},
    EventFacts{"sealed_names"},
    EventFacts{
        "copied_forms", {"{forms} forms of the library", "forms", "{forms} form of the library"}},
    EventFacts{"copied_consent", {"of {participant}"}},
    EventFacts{"showed_names", {"{names} names", "names", "{names} name"}},
    EventFacts{"finished_step"},
    EventFacts{"gave_consent"},
    EventFacts{"declined_consent"},
    EventFacts{"began_trial"},
    EventFacts{"finished_trial", {"{cuts} cuts, {verdict}", "cuts", "{cuts} cut, {verdict}"}},
    EventFacts{"broke_off_trial"},
    EventFacts{"repeated_step"},
    EventFacts{"skipped_step"},
    EventFacts{"paused_session"},
    EventFacts{"resumed_session"},
    EventFacts{"finished_session"},
    EventFacts{"withdrew"},
    EventFacts{"was_rejected"},
    EventFacts{"gave_up_on_device"},
    EventFacts{"enrolled", {"{participant} {cohort} {run_mode}, place {place}"}},
    EventFacts{
        "resumed",
        {"{pause_s:.0f} s after the last event by the wall clock alone: whether that was set in "
         "between is not known"}},
    EventFacts{"took_over", {"from {station}, process {process}, since {since}: {reason}"}},
    EventFacts{"clock_stepped", {"by {by_s:.6f} s; durations are not affected"}},
    EventFacts{"chose_language"},
    EventFacts{"showed_forces"},
    EventFacts{"note"},
    EventFacts{"answered", {"{item}"}},
    EventFacts{"retracted"},
    EventFacts{"switched_reamer"},
    EventFacts{"kept_trace"},
    EventFacts{
        "passivity",
        {"K {stiffness:.4g}, T {period_s:.4g} s, needs b {needed_damping:.3g}, device has "
         "{device_damping:.3g}, least energy {least_energy:.3g}"}},
    EventFacts{
        "torque", {"at most {largest_nm:.3g} N·m, least energy of the turn {least_energy:.3g} J"}},
    EventFacts{
        "device_link",
        {"received {received}, lost {lost}, doubled {doubled}, late {late}, damaged {damaged}, "
         "foreign {foreign}, restarts {restarts}, skipped {skipped}, stale {stale}, poor {poor}, "
         "unsent {unsent}, clipped {clipped}, expired {expired}; round trip p50 {trip_p50_us:.0f} "
         "us, p99 {trip_p99_us:.0f} us, largest {trip_max_us:.0f} us; device's 0 at "
         "{clock_offset_ns} ns of our clock"}},
    EventFacts{"device_fault"},
    EventFacts{
        "view",
        {"frames {frames}, dropped {dropped}, {rate_per_s:.1f} 1/s; from frame to frame p50 "
         "{frame_p50_ms:.1f} ms, p99 {frame_p99_ms:.1f} ms, meant {period_ms:.1f} ms; latency p50 "
         "{latency_p50_ms:.1f} ms, p99 {latency_p99_ms:.1f} ms; changes lost {lost_changes}; "
         "drawn by {renderer}"}},
    EventFacts{"safety_too_fast", kSafety},
    EventFacts{"safety_released", kSafety},
    EventFacts{"safety_no_sample", kSafety},
    EventFacts{"safety_lost_beats", kSafety},
    EventFacts{"safety_soft_start", kSafety},
    EventFacts{"safety_saturated", kSafety},
    EventFacts{"safety_slewed", kSafety},
    EventFacts{"safety_not_finite", kSafety},
    EventFacts{"safety_active", kSafety},
    EventFacts{"safety_damped", kSafety},
    EventFacts{"safety_torque_saturated", kSafety},
    EventFacts{"safety_torque_slewed", kSafety},
    EventFacts{"safety_torque_active", kSafety},
};
static_assert(!kFacts.back().name.empty(), "every kind has a name");

}  // namespace

std::string_view nameOf(EventKind kind) noexcept {
  return kind == EventKind::Unknown ? "" : kFacts[static_cast<std::size_t>(kind)].name;
}

EventKind eventKindNamed(std::string_view name) noexcept {
  const auto found = std::ranges::find(kFacts, name, &EventFacts::name);
  return static_cast<EventKind>(found - kFacts.begin());
}

EventPattern patternOf(EventKind kind) noexcept {
  return kind == EventKind::Unknown ? EventPattern()
                                    : kFacts[static_cast<std::size_t>(kind)].pattern;
}

}  // namespace study
