#include "tests/study/made_study.h"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"

namespace tests {
namespace {

// Thousands of commits do not need a disk: if there is enough memory, studies are stored there.
// TMPDIR names another place.
[[maybe_unused]] const bool kIsInMemory = [] {
  constexpr std::uintmax_t kEnough = std::uintmax_t{2} << 30;  // [bytes]
  std::error_code error;
  const auto space = std::filesystem::space("/dev/shm", error);
  return !error && space.available > kEnough && setenv("TMPDIR", "/dev/shm", 0) == 0;
}();

const std::string& sceneOf(const std::string& condition) {
  static const std::string kInterpolation =
      R"({"device": "punch", "model": "interpolation",
          "parameters": {"cut": "parametric", "beyond": "ramp-out"}})";
  static const std::string kFiniteElements =
      R"({"device": "punch", "model": "finite-elements",
          "parameters": {"elements": 5, "contact_travel": 4.0, "yield_force_n": 7.0}})";
  static const std::string kKalman =
      R"({"device": "punch", "model": "kalman", "parameters": {
          "variant": "authors-firmware",
          "interpolation": {"cut": "parametric", "beyond": "ramp-out"},
          "finite_elements": {"elements": 5, "contact_travel": 4.0, "yield_force_n": 7.0},
          "noise": {"process_force": 7.0275, "process_covariance": 0.2772,
                    "process_stiffness": 6.1024, "finite_elements": 0.001,
                    "interpolation": 7.742}}})";
  if (condition == "finite-elements") return kFiniteElements;
  return condition == "kalman" ? kKalman : kInterpolation;
}

std::string conditionsIn(const std::vector<std::string>& ids) {
  std::string text;
  for (const auto& id : ids) {
    text += text.empty() ? "" : ",";
    text += R"({"id": ")" + id + R"(", "title": "The title of )" + id + R"(", "scene": )" +
            sceneOf(id) + "}";
  }
  return "[" + text + "]";
}

std::string listOf(const std::vector<std::string>& ids) {
  std::string text;
  for (const auto& id : ids) text += (text.empty() ? "\"" : ",\"") + id + "\"";
  return "[" + text + "]";
}

std::string blockOf(const ShortProtocol& options) {
  std::string text = R"({"id": "felt", "type": "block", "order": {"type": ")" + options.order +
                     R"("}, "minimum_cuts": )" + std::to_string(options.minimumCuts) +
                     R"(, "conditions": )" + listOf(options.conditions);
  if (!options.questionnaire.empty()) {
    text += R"(, "questionnaires": [{"instrument": ")" + options.questionnaire + R"("}])";
  }
  return text + "}";
}

/// One comparison of the first two conditions, by the questionnaire.
std::string analysisOf(const ShortProtocol& options) {
  if (options.questionnaire.empty() || options.conditions.size() < 2) return {};
  return R"(, "analysis": {"families": [{"id": "methods", "title": "Realism", "instrument": ")" +
         options.questionnaire + R"(", "comparisons": [{"first": ")" + options.conditions[0] +
         R"(", "second": ")" + options.conditions[1] +
         R"("}], "test": "welch", "correction": "bonferroni", "alpha": 0.05}]})";
}

}  // namespace

protocols::LoadedProtocol libraryProtocol(const std::string& name) {
  questionnaires::Problems problems;
  auto loaded = protocols::loadProtocolFile(name, problems);
  if (!loaded) throw std::runtime_error(questionnaires::describe(problems.all()));
  return std::move(*loaded);
}

protocols::LoadedProtocol filledIn(const protocols::LoadedProtocol& protocol) {
  const std::map<std::string, std::string> words{
      {"institution", "the Example University Hospital"},
      {"contact", "Dr Anna Berg, anna.berg@example.org"},
      {"duration", "20"},
      {"ethics", "Regional Ethics Committee, reference 2026/123"},
      {"delete_until", "31 March 2027"},
      {"names_seen_by", "the responsible researcher"},
      {"names_destroyed", "31 December 2027"},
      {"data_kept_years", "10"},
      {"data_protection_officer", "Kari Lie, privacy@example.org"},
      {"data_protection_authority", "the national data protection authority"}};
  questionnaires::BlankTexts texts;
  for (const auto& blank : protocols::blanksOf(protocol)) {
    const auto found = words.find(blank.key);
    texts[blank.key] =
        questionnaires::LocalizedText({{"en", found == words.end() ? "filled in" : found->second}});
  }
  questionnaires::Problems problems;
  auto filled = protocols::withTexts(protocol, texts, problems);
  if (!filled) throw std::runtime_error(questionnaires::describe(problems.all()));
  return std::move(*filled);
}

protocols::LoadedProtocol protocolFrom(
    const std::string& json, const std::vector<protocols::SourceFile>& files) {
  questionnaires::Problems problems;
  auto loaded = protocols::loadProtocol(json, files, problems);
  if (!loaded) throw std::runtime_error(questionnaires::describe(problems.all()));
  return std::move(*loaded);
}

std::string shortProtocol(const ShortProtocol& options) {
  const std::string form =
      options.form.empty()
          ? ""
          : R"({"id": "form", "type": "form", "instrument": ")" + options.form + R"("},)";
  const std::string again = options.offersAgain ? R"(, "feel_again": true)" : "";
  const std::string preference =
      options.hasPreference
          ? R"({"id": "choice", "type": "preference", "instrument": "preference-cuts", "block": "felt")" +
                again + "},"
          : "";
  return R"({"$schema": "protocol-1.schema.json",
    "study": {"id": "short", "title": "A short study", "version": "1"},
    "languages": ["en", "de", "nb"],
    "cohorts": [{"id": "surgeons", "title": "Surgeons"}, {"id": "students", "title": "Students"}],
    "devices": [{"id": "punch", "kind": "punch", "max_force_n": 8.0, "max_force_rate_n_per_s": 500.0}],
    "instrument_files": [)" +
         options.files + R"(],
    "conditions": )" +
         conditionsIn(options.conditions) + R"(,
    "labels": {"policy": ")" +
         options.labels + R"(", "prefix": "Alternative"},
    "phases": [{"id": "consent", "type": "consent", "instrument": "consent-punch"},)" +
         form + blockOf(options) + "," + preference +
         R"({"id": "debrief", "type": "debrief", "instrument": "debrief"}])" + analysisOf(options) +
         "}";
}

// NOLINTBEGIN(concurrency-mt-unsafe): set while a test has one thread
OwnStation::OwnStation(const std::string& folder) {
  const char* before = std::getenv("PALPATE_STATION");
  if (before != nullptr) before_ = before;
  setenv("PALPATE_STATION", folder.c_str(), 1);
}

void forgetWhatWasSigned() {
  namespace fs = std::filesystem;
  const char* station = std::getenv("PALPATE_STATION");
  std::error_code error;
  if (station == nullptr || !fs::exists(station, error)) return;
  for (const auto& entry : fs::directory_iterator(station)) {
    const auto name = entry.path().filename();
    if (name != "study-keys" && name != "key") fs::remove(entry.path());
  }
}

OwnStation::~OwnStation() {
  before_ ? setenv("PALPATE_STATION", before_->c_str(), 1) : unsetenv("PALPATE_STATION");
}
// NOLINTEND(concurrency-mt-unsafe)

MadeStudy::MadeStudy(
    const protocols::LoadedProtocol& protocol,
    std::uint64_t seed,
    const study::storage::BlindingSecret& secret) {
  study_.emplace(study::Study::create(folder(), protocol, clock, seed, secret));
}

void MadeStudy::reopen() {
  close();
  study_.emplace(study::Study::open(folder(), clock));
}

}  // namespace tests
