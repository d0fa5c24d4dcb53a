// Warnings on what a protocol plans: families, the course of a session, what two conditions share.
#include <algorithm>
#include <string>

#include "base/search.h"
#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

using questionnaires::Instrument;
using questionnaires::Problems;
using questionnaires::Score;
using questionnaires::shown;

constexpr double kLargestUsualAlpha = 0.2;

std::string placeIn(const char* list, std::size_t index) {
  return "$." + std::string(list) + "[" + std::to_string(index) + "]";
}

bool isAlwaysAsked(const Instrument& instrument, const std::string& id) {
  const auto* item = instrument.item(id);
  return item != nullptr && !item->showIf.isSet();
}

/// An item that @p score cannot do without, and that is asked only after some answers; empty if
/// there is none.
std::string conditionalItemOf(const Instrument& instrument, const Score& score) {
  const auto isAsked = [&](const std::string& id) { return isAlwaysAsked(instrument, id); };
  const auto asked = static_cast<std::size_t>(std::ranges::count_if(score.items, isAsked));
  const auto needed = score.leastAnswered == 0 ? score.items.size() : score.leastAnswered;
  if (asked >= needed) return {};
  return *std::ranges::find_if_not(score.items, isAsked);
}

bool areAlike(const Family& a, const Family& b) {
  const auto isSamePair = [](const Comparison& one, const Comparison& other) {
    return (one.first == other.first && one.second == other.second) ||
           (one.first == other.second && one.second == other.first);
  };
  return a.instrument == b.instrument && a.items == b.items && a.score == b.score &&
         a.blocks == b.blocks && a.test == b.test &&
         std::ranges::is_permutation(a.comparisons, b.comparisons, isSamePair);
}

void warnOfFamily(const LoadedProtocol& loaded, std::size_t index, Problems& problems) {
  const auto& families = loaded.protocol.analysis.families;
  const auto& family = families[index];
  const std::string path = placeIn("analysis.families", index);
  if (family.alpha > kLargestUsualAlpha) {
    problems.warn(
        path + ".alpha", message("alpha_large", shown(family.alpha)), message("alpha_large.fix"));
  }
  const auto end = families.begin() + static_cast<std::ptrdiff_t>(index);
  const auto twin = std::find_if(
      families.begin(), end, [&](const auto& other) { return areAlike(other, family); });
  if (twin != end) {
    problems.warn(path, message("same_family", twin->id), message("same_family.fix"));
  }
  const auto& instrument = *loaded.instrument(family.instrument);
  const auto* score = instrument.score(family.score);
  const auto item = score == nullptr ? std::string() : conditionalItemOf(instrument, *score);
  if (!item.empty()) {
    problems.warn(
        path + ".score",
        message("score_not_always_asked", score->id, item),
        message("score_not_always_asked.fix"));
  }
}

bool isQuestion(const Phase& phase) {
  return phase.type == PhaseType::Form || phase.type == PhaseType::Interview;
}

/// Warns of questions before consent, and of anything that is felt or asked of a participant after
/// the debriefing.
void warnOfCourse(const Protocol& protocol, Problems& problems) {
  bool hasConsent = false;
  const Phase* debriefing = nullptr;
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const auto& phase = protocol.phases[i];
    hasConsent = hasConsent || phase.type == PhaseType::Consent;
    if (phase.type == PhaseType::Debrief) debriefing = &phase;
    if (isQuestion(phase) && !hasConsent) {
      problems.warn(
          placeIn("phases", i),
          message("asked_before_consent"),
          message("asked_before_consent.fix"));
    }
    const bool isFelt = phase.type == PhaseType::Block || phase.type == PhaseType::Benchmark ||
                        phase.type == PhaseType::Preference;
    if (isFelt && debriefing != nullptr) {
      problems.warn(
          placeIn("phases", i),
          message("felt_after_debriefing", debriefing->id),
          message("felt_after_debriefing.fix"));
    }
  }
}

/// Whether @p date looks like 2026, 2026-11 or 2026-11-20.
bool isIsoDate(const std::string& date) {
  constexpr std::string_view kForm = "dddd-dd-dd";
  if (date.size() != 4 && date.size() != 7 && date.size() != kForm.size()) return false;
  for (std::size_t i = 0; i < date.size(); ++i) {
    const bool isDigit = date[i] >= '0' && date[i] <= '9';
    if (kForm[i] == 'd' ? !isDigit : date[i] != kForm[i]) return false;
  }
  return true;
}

void warnOfDate(const StudyMetadata& study, Problems& problems) {
  if (study.date.empty() || isIsoDate(study.date)) return;
  problems.warn("$.study.date", message("date_not_iso", study.date), message("date_not_iso.fix"));
}

void warnOfLanguages(const Protocol& protocol, Problems& problems) {
  std::string known;
  for (const auto language : kWindowLanguages) {
    known.append(known.empty() ? "" : ", ").append(language);
  }
  for (const auto& language : protocol.languages) {
    const std::string_view tag(language);
    if (base::contains(kWindowLanguages, tag.substr(0, tag.find('-')))) continue;
    problems.warn(
        "$.languages",
        message("language_of_windows", language),
        message("language_of_windows.fix", known));
  }
}

}  // namespace

void addPlanWarnings(const LoadedProtocol& loaded, Problems& problems) {
  const auto& protocol = loaded.protocol;
  warnOfDate(protocol.study, problems);
  warnOfLanguages(protocol, problems);
  warnOfCourse(protocol, problems);
  for (std::size_t i = 0; i < protocol.analysis.families.size(); ++i) {
    warnOfFamily(loaded, i, problems);
  }
}

}  // namespace protocols
