#include "study/report/report_section.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "protocols/load_protocol.h"
#include "study/export/statistics_row.h"
#include "study/model/data_table.h"
#include "study/report/small_samples.h"

namespace study::report {
namespace {

/// Counts a trial together with others whose reasons are of the same kinds. Leaves out the reason
/// that the force was limited, which is reported by condition.
void addReasons(std::vector<TrialReasons>& all, std::vector<base::Message> reasons) {
  std::erase_if(reasons, [](const auto& reason) { return reason.key() == "trial.cut_off"; });
  if (reasons.empty()) return;
  const auto known = std::ranges::find_if(all, [&](const auto& other) {
    return std::ranges::equal(other.reasons, reasons, {}, &base::Message::key, &base::Message::key);
  });
  if (known == all.end()) {
    all.push_back({std::move(reasons)});
  } else {
    ++known->trials;
  }
}

std::set<SessionId> completedSessions(const storage::Records& records, RunMode mode) {
  std::set<SessionId> completed;
  for (const auto& session : records.sessions()) {
    if (session.runMode == mode && session.isCompleted()) completed.insert(session.id);
  }
  return completed;
}

/// All visits to the trials of @p sessions.
std::vector<storage::StoredTrial> trialsOf(
    const storage::Records& records, const std::set<SessionId>& sessions) {
  auto trials = records.trials();
  std::erase_if(
      trials, [&](const auto& trial) { return !sessions.contains(trial.step.visit.session); });
  return trials;
}

TrialQuality qualityOf(Study& study, RunMode mode) {
  TrialQuality quality;
  std::map<std::string, SaturatedTrials> saturatedTrials;
  std::map<std::string, ConditionTrials> felt;
  const storage::Records records(study.database());
  const auto completed = completedSessions(records, mode);
  for (const auto& [where, trials] : records.unfinishedTrials()) {
    if (completed.contains(where.first)) quality.interrupted.skipped[where.second] += trials;
  }
  for (const auto& trial : trialsOf(records, completed)) {
    const bool isOptional = trial.step.isOptionalRepetition();
    if (!trial.step.isFinished()) {
      if (isOptional) continue;
      if (trial.step.visitStatus == storage::VisitStatus::Repeated) ++quality.interrupted.repeated;
      if (trial.ending != TrialEnding::Finished) ++quality.interrupted.brokenOff[trial.ending];
      continue;
    }
    if (isOptional) {
      ++quality.optionalTrials;
      continue;
    }
    ++quality.trials;
    quality.pass += trial.verdict == Verdict::Pass ? 1 : 0;
    quality.warn += trial.verdict == Verdict::Warn ? 1 : 0;
    quality.fail += trial.verdict == Verdict::Fail ? 1 : 0;
    quality.cuts += trial.cuts;
    quality.saturated += trial.saturated;
    quality.contact += trial.contact;
    if (trial.latenessP99) {
      quality.worstLateness = std::max(quality.worstLateness.value_or(0.0), *trial.latenessP99);
    }
    quality.rate = std::max(quality.rate, trial.nominalRate);
    auto& counted = felt[trial.step.condition];
    ++counted.trials;
    counted.cuts += trial.cuts;
    addReasons(quality.reasons, trial.reasons);
    auto& ofCondition = saturatedTrials[trial.step.condition];
    ++ofCondition.trials;
    if (trial.saturated > 0.0 && trial.contact > 0.0) {
      ofCondition.shares.push_back(trial.saturated / trial.contact);
    }
  }
  for (const auto& condition : study.protocol().protocol.conditions) {
    auto& counted = felt[condition.id];
    counted.condition = condition.id;
    if (counted.trials > 0) quality.conditions.push_back(counted);
    auto& found = saturatedTrials[condition.id];
    if (found.shares.empty()) continue;
    found.condition = condition.id;
    std::ranges::sort(found.shares);
    quality.saturatedTrials.push_back(std::move(found));
  }
  return quality;
}

/// The first and the last day on which a session that counts began; empty if there is none.
std::pair<std::string, std::string> daysOf(Study& study, RunMode mode) {
  std::pair<std::string, std::string> days;
  for (const auto& session : storage::Records(study.database()).sessions()) {
    if (session.runMode != mode || !session.isCompleted()) continue;
    const auto day = session.startedUtc.substr(0, session.startedUtc.find('T'));
    days.first = days.first.empty() ? day : std::min(days.first, day);
    days.second = std::max(days.second, day);
  }
  return days;
}

/// How many live sessions that count have shown the forces to their operator. Windows of release
/// 0.1 always showed them, and did not record it.
int sessionsWithForces(Study& study, RunMode mode) {
  if (mode != RunMode::Live) return 0;
  std::set<SessionId> shown;
  for (const auto& event : study.events().read(EventKind::ShowedForces)) {
    if (event.visit && event.detail != "off") shown.insert(event.visit->session);
  }
  const auto sessions = storage::Records(study.database()).sessions();
  return static_cast<int>(std::ranges::count_if(sessions, [&](const auto& session) {
    const bool isOfRelease01 = session.appVersion.starts_with("0.1.");
    return session.runMode == mode && session.isCompleted() &&
           (isOfRelease01 || shown.contains(session.id));
  }));
}

using Coordinate = std::optional<double> storage::CutRecord::*;

/// A landmark of a cut, as the column names call it.
struct Landmark {
  std::string_view name;
  Coordinate travel;
  Coordinate force;
};

constexpr std::array kLandmarks{
    Landmark{
        "interception",
        &storage::CutRecord::interceptionTravel,
        &storage::CutRecord::interceptionForce},
    Landmark{"yield", &storage::CutRecord::yieldTravel, &storage::CutRecord::yieldForce},
    Landmark{
        "bottom-out", &storage::CutRecord::bottomOutTravel, &storage::CutRecord::bottomOutForce},
    Landmark{"opening", &storage::CutRecord::openingTravel, &storage::CutRecord::openingForce}};

std::vector<double> valuesOf(const std::vector<storage::CutRecord>& cuts, Coordinate coordinate) {
  std::vector<double> values;
  for (const auto& cut : cuts) {
    if (const auto& value = cut.*coordinate) values.push_back(*value);
  }
  return values;
}

std::vector<LandmarkSummary> landmarksOf(Study& study, RunMode mode) {
  const storage::Records records(study.database());
  std::map<VisitKey, storage::StoredTrial> trials;
  for (auto& trial : trialsOf(records, completedSessions(records, mode))) {
    const bool counts = trial.step.isFinished() && !trial.step.isOptionalRepetition();
    if (counts) trials.emplace(trial.step.visit, std::move(trial));
  }
  std::map<std::string, std::vector<storage::CutRecord>> cuts;
  for (const auto& cut : records.cuts()) {
    const auto trial = trials.find(cut.visit);
    if (trial == trials.end()) continue;
    cuts[trial->second.step.condition].push_back(cut);
  }
  std::vector<LandmarkSummary> all;
  for (const auto& condition : study.protocol().protocol.conditions) {
    const auto& own = cuts[condition.id];
    const auto add = [&](std::string_view name, const auto& travel, const auto& force) {
      if (force.empty()) return;
      all.push_back({condition.id, name, analysis::summarise(travel), analysis::summarise(force)});
    };
    for (const auto& one : kLandmarks) {
      add(one.name, valuesOf(own, one.travel), valuesOf(own, one.force));
    }
    std::vector<double> peaks;
    for (const auto& cut : own) peaks.push_back(cut.peakForce);
    add("largest force", std::vector<double>(), peaks);
  }
  return all;
}

/// The warnings of `palpate protocol check` about the stored protocol.
std::vector<questionnaires::Problem> warningsOf(Study& study) {
  const auto stored = study.protocols().current();
  questionnaires::Problems problems;
  protocols::loadProtocol(stored.text, stored.files, problems, stored.defaults);
  return problems.all();
}

/// @p words with the texts of the devices in @p protocol. If all devices are of one kind, its texts
/// take precedence over the catalogue's; otherwise they are used only where the catalogue has none.
words::Words withDevices(const words::Words& words, const protocols::Protocol& protocol) {
  auto catalogue = words.catalogue();
  for (const auto& device : protocol.devices) {
    for (const auto& sentence : device.kind->sentences) {
      if (sentence.language != words.language()) continue;
      const std::string english(sentence.english);
      if (protocol.onlyDeviceKind() != nullptr) {
        catalogue.texts.insert_or_assign(english, sentence.text);
      } else if (words.language() != "en") {
        catalogue.texts.emplace(english, sentence.text);
      }
    }
  }
  return {words.language(), std::move(catalogue)};
}

}  // namespace

const questionnaires::Instrument* ReportSection::instrument(std::string_view id) const {
  const auto found = std::ranges::find(instruments, id, &questionnaires::Instrument::id);
  return found == instruments.end() ? nullptr : &*found;
}

const std::string& ReportSection::conditionTitle(const std::string& condition) const {
  return protocol.condition(condition)->title;
}

int ReportSection::conditionIndex(const std::string& condition) const {
  const auto& all = protocol.conditions;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.id == condition; });
  return static_cast<int>(found - all.begin());
}

const std::string& ReportSection::cohortTitle(const std::string& cohort) const {
  return protocol.cohort(cohort)->title.in(words.language());
}

std::string ReportSection::introducedTitle(const std::string& condition) const {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kModels{
      {{"finite-elements", "finite elements"}, {"kalman", "Kalman filter"}}};
  const auto& title = conditionTitle(condition);
  const auto& model = protocol.condition(condition)->model;
  const bool isAbbreviation =
      std::ranges::none_of(title, [](char letter) { return letter >= 'a' && letter <= 'z'; });
  for (const auto& [name, english] : kModels) {
    const auto inFull = words(english);  // of every model: tests find missing translations
    if (isAbbreviation && model && haptics::engine::infoOf(*model).name == name) {
      return title + " (" + inFull + ")";
    }
  }
  return title;
}

std::string ReportSection::blockTitle(const std::string& block) const {
  int number = 0;
  std::optional<bool> isVisualised;
  std::set<std::optional<bool>> kinds;
  int found = 0;
  for (const auto& phase : protocol.phases) {
    if (phase.type != protocols::PhaseType::Block) continue;
    ++number;
    kinds.insert(phase.trials.isVisualised);
    if (phase.id != block) continue;
    found = number;
    isVisualised = phase.trials.isVisualised;
  }
  if (found == 0) return block;
  const bool doDiffer = kinds.size() == 2 && !kinds.contains(std::nullopt);
  const auto seen = words.say("round {} (also seen)", found);
  const auto felt = words.say("round {} (felt only)", found);
  const auto plain = words.say("round {}", found);
  return !doDiffer ? plain : *isVisualised ? seen : felt;
}

std::string ReportSection::titleOf(const std::string& id) const {
  const auto& language = words.language();
  if (const auto* one = protocol.condition(id)) return one->title;
  if (const auto* one = protocol.cohort(id)) return one->title.in(language);
  for (const auto& instrument : instruments) {
    if (instrument.id == id) return instrument.title.in(language);
    if (const auto* item = instrument.item(id)) return questionOf(*item, language);
  }
  return blockTitle(id);
}

std::string ReportSection::inWords(const base::Message& message) const {
  auto arguments = message.arguments();
  for (auto& argument : arguments) {
    auto* text = std::get_if<std::string>(&argument);
    if (text == nullptr) continue;
    std::string titles;  // of all ids, if the argument is a list: "1.1, 1.2"
    for (std::size_t at = 0; at <= text->size();) {
      const auto end = std::min(text->find(", ", at), text->size());
      const auto id = text->substr(at, end - at);
      auto title = titleOf(id);
      const bool isSentence = title != id && title.ends_with('.');
      if (isSentence) title.pop_back();
      titles += (at == 0 ? "" : isSentence ? "; " : ", ") + title;
      at = end + 2;
    }
    *text = titles;
  }
  const base::MessageKind kind{message.key(), message.english()};
  return message.key().empty() ? words(message) : words(base::Message(kind, arguments));
}

std::string originInWords(const ReportSection& section) {
  switch (section.results.runMode) {
    case RunMode::Live:
      return {};
    case RunMode::Pilot:
      return section.words("Pilot sessions: not for publication.");
    case RunMode::Simulated:
      return section.words(
          "Simulated: nobody took part. These numbers show what the program does; they say "
          "nothing about any method.");
  }
  return {};
}

std::string listed(const std::vector<std::string>& names, const words::Words& words) {
  std::string first;
  for (std::size_t i = 0; i + 1 < names.size(); ++i) first += (i == 0 ? "" : ", ") + names[i];
  if (names.empty()) return {};
  const auto both = words.say("{} and {}", first, names.back());
  return first.empty() ? names.back() : both;
}

std::string questionOf(const questionnaires::Item& item, const std::string& language) {
  const auto& text = item.text.in(language);
  if (!text.empty() && text.find("[[") == std::string::npos) return text;
  const auto& left = item.leftText.in(language);
  return left.empty() ? item.id : left + " – " + item.rightText.in(language);
}

std::pair<std::string, std::string> scaleEndWords(
    const questionnaires::Item& item, const std::string& language) {
  const bool isPoint = questionnaires::answerKindOf(item.type) == questionnaires::AnswerKind::Point;
  const auto scale = isPoint ? item.scale : questionnaires::Scale{};
  const auto either = [&](const auto& one, const auto& other) {
    const auto& text = one.in(language).empty() ? other.in(language) : one.in(language);
    return text.find("[[") == std::string::npos ? text : std::string();
  };
  // The labels at an item's own scale take precedence over those of a form's scale.
  return {either(item.leftText, scale.lowLabel), either(item.rightText, scale.highLabel)};
}

std::string scaleInWords(
    const std::vector<const questionnaires::Item*>& items, const words::Words& words) {
  if (items.empty()) return {};
  const auto scale = protocols::scaleOf(*items.front());
  const auto isAlike = [&](const auto* item) { return protocols::scaleOf(*item) == scale; };
  if (!scale || !std::ranges::all_of(items, isAlike)) return {};
  const auto ends = scaleEndWords(*items.front(), words.language());
  const bool haveSameEnds = std::ranges::all_of(
      items, [&](const auto* item) { return scaleEndWords(*item, words.language()) == ends; });
  const auto low = withMinusSign(exactDecimal(scale->lowest));
  const auto high = withMinusSign(exactDecimal(scale->highest));
  const auto plain = words.say("scale from {} to {}", low, high);
  const auto named = words.say("scale from {} ({}) to {} ({})", low, ends.first, high, ends.second);
  const bool isNamed = haveSameEnds && !ends.first.empty() && !ends.second.empty();
  return isNamed ? named : plain;
}

std::string scaleInWords(const ReportSection& section, const protocols::Family& family) {
  const auto* instrument = section.instrument(family.instrument);
  if (instrument == nullptr) return {};
  if (!family.score.empty()) {
    const auto scale = protocols::scaleOf(family, *instrument);
    if (!scale) return {};
    return section.words.say(
        "scale from {} to {}",
        withMinusSign(exactDecimal(scale->lowest)),
        withMinusSign(exactDecimal(scale->highest)));
  }
  std::vector<const questionnaires::Item*> items;
  const auto compared = protocols::comparedItems(family, instrument->items);
  for (const auto& item : compared) items.push_back(&item);
  return scaleInWords(items, section.words);
}

namespace {

/// The unit that all compared items have; empty if there is none.
std::string commonUnit(const ReportSection& section, const protocols::Family& family) {
  const auto* instrument = section.instrument(family.instrument);
  if (instrument == nullptr || !family.score.empty()) return {};
  std::set<std::string> units;
  for (const auto& item : protocols::comparedItems(family, instrument->items)) {
    if (protocols::scaleOf(item)) units.insert(item.unit);
  }
  return units.size() == 1 ? *units.begin() : std::string();
}

}  // namespace

std::string unitInWords(const ReportSection& section, const protocols::Family& family) {
  const auto unit = commonUnit(section, family);
  const auto points = section.words("points");
  return unit.empty() ? points : unit;
}

std::string withUnit(
    const ReportSection& section, const protocols::Family& family, const std::string& number) {
  const auto unit = commonUnit(section, family);
  const auto points = section.words.say("{} points", number);
  const auto point = section.words("1 point");
  return !unit.empty() ? number + "\u00a0" + unit : number == "1" ? point : points;
}

std::vector<std::pair<std::string, std::string>> namedFigures(const ReportSection& section) {
  std::vector<std::pair<std::string, std::string>> named;
  const auto add = [&](const std::string& name, const std::string& svg) {
    if (!svg.empty()) named.emplace_back(name, svg);
  };
  const auto& all = section.figures;
  for (std::size_t i = 0; i < all.families.size(); ++i) {
    const auto& id = section.results.families[i].family.id;
    add(id + "-answers", all.families[i].answers);
    add(id + "-people", all.families[i].participantMeans);
    add(id + "-effects", all.families[i].effects);
    add(id + "-sites", all.families[i].sites);
  }
  add("preferences", all.votes);
  for (const auto& one : all.items) add("item-" + one.instrument + "-" + one.item, one.svg);
  for (std::size_t i = 0; i < all.renderedForce.size(); ++i) {
    add("felt" + (all.renderedForce.size() > 1 ? "-" + std::to_string(i + 1) : std::string()),
        all.renderedForce[i]);
  }
  return named;
}

ReportSection gatherResults(Study& study, RunMode mode, const words::Words& words) {
  auto [firstDay, lastDay] = daysOf(study, mode);
  auto results = computeResults(study, mode, PairOrder::HigherFirst);
  leaveOutSmallSamples(results, study.protocol().instruments);
  auto warnings = warningsOf(study);
  for (const auto& change : results.changes) warnings.push_back({.path = {}, .what = change});
  return {
      .protocol = study.protocol().protocol,
      .instruments = study.protocol().instruments,
      .sources = study.protocol().sources,
      .protocolHash = study.protocols().current().sha256,
      .history = analysisPlanHistory(study),
      .seed = study.seed(),
      .uuid = study.uuid(),
      .firstDay = std::move(firstDay),
      .lastDay = std::move(lastDay),
      .sessionsWithForces = sessionsWithForces(study, mode),
      // Simulated sessions can be repeated from a seed and must then give the same report.
      .trail = mode == RunMode::Simulated ? storage::TrailEnd() : storage::endOf(study.database()),
      .commitment = mode == RunMode::Simulated ? std::string() : study.events().commitment(),
      .results = std::move(results),
      .warnings = std::move(warnings),
      .words = withDevices(words, study.protocol().protocol)};
}

ReportSection gather(Study& study, RunMode mode, const words::Words& words) {
  auto section = gatherResults(study, mode, words);
  auto forces = renderedForceResult(study, mode);
  section.curves = std::move(forces.curves);
  section.curvesReason = std::move(forces.reason);
  section.quality = qualityOf(study, mode);
  section.landmarks = landmarksOf(study, mode);
  return section;
}

}  // namespace study::report
