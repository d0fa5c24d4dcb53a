#include "protocols/protocol_file.h"

#include <array>
#include <map>

#include "protocols/localized_file.h"
#include "protocols/phase_file.h"
#include "protocols/scene_file.h"
#include "questionnaires/document.h"

namespace protocols {
namespace {

using haptics::devices::DeviceKind;
using questionnaires::Choice;
using questionnaires::Node;

constexpr std::string_view kSchema = "protocol-1.schema.json";
constexpr std::int64_t kMostExactWhole = std::int64_t{1} << 53;

constexpr std::array kDeviceKinds{
    Choice<DeviceKind>{"punch", DeviceKind::Punch},
    Choice<DeviceKind>{"reamer", DeviceKind::Reamer},
};
constexpr std::array kPolicies{
    Choice<LabelPolicy>{"condition", LabelPolicy::Condition},
    Choice<LabelPolicy>{"position", LabelPolicy::Position},
    Choice<LabelPolicy>{"random", LabelPolicy::Random},
};
constexpr std::array kTests{Choice<TestType>{"welch", TestType::Welch}};
constexpr std::array kCorrections{
    Choice<CorrectionType>{"bonferroni", CorrectionType::Bonferroni},
    Choice<CorrectionType>{"none", CorrectionType::None},
};

void requireSchema(const Node& root) {
  const std::string schema = root.text("$schema");
  const bool isOurs = schema == kSchema || (schema.size() > kSchema.size() &&
                                            schema.ends_with("/" + std::string(kSchema)));
  if (!schema.empty() && !isOurs) {
    root.problem(
        "$schema",
        "this is not the schema of a protocol that this program reads",
        "write \"" + std::string(kSchema) + "\"");
  }
}

StudyMetadata readMetadata(const Node& node) {
  StudyMetadata study;
  if (!node.isObjectWith(
          {"id", "title", "version", "authors", "organizations", "date", "description"})) {
    return study;
  }
  study.id = node.id("id");
  study.title = node.text("title");
  study.version = node.text("version");
  study.authors = node.texts("authors");
  study.organizations = node.texts("organizations");
  study.date = node.text("date", "");
  study.description = node.text("description", "");
  return study;
}

Cohort readCohort(const Node& node) {
  Cohort cohort;
  if (!node.isObjectWith({"id", "title", "planned"})) return cohort;
  cohort.id = node.id("id");
  cohort.title = readLocalized(node, "title");
  cohort.planned = static_cast<int>(node.wholeNumber("planned", 0, 10'000, 0));
  return cohort;
}

DeviceNeed readDevice(const Node& node) {
  DeviceNeed device;
  if (!node.isObjectWith({"id", "kind", "max_force_n", "max_force_rate_n_per_s"})) return device;
  device.id = node.id("id");
  device.kind = node.choice("kind", kDeviceKinds);
  device.maxForce = node.number("max_force_n", 0.01, 1000.0);
  device.maxForceRate = node.number("max_force_rate_n_per_s", 0.1, 1e6);
  return device;
}

Condition readCondition(const Node& node) {
  Condition condition;
  if (!node.isObjectWith({"id", "title", "scene"})) return condition;
  condition.id = node.id("id");
  condition.title = node.text("title");
  if (const auto scene = node.requiredObject("scene")) readScene(*scene, condition);
  return condition;
}

Labels readLabels(const Node& root) {
  Labels labels{.prefix = LocalizedText(std::map<std::string, std::string>{{"en", "Alternative"}})};
  const auto node = root.requiredObject("labels");
  if (!node || !node->isObjectWith({"policy", "prefix"})) return labels;
  labels.policy = node->choice("policy", kPolicies);
  if (node->has("prefix")) labels.prefix = readLocalized(*node, "prefix");
  return labels;
}

std::vector<Comparison> readComparisons(const Node& family) {
  std::vector<Comparison> comparisons;
  for (const auto& node : family.requiredList("comparisons")) {
    if (!node.isObjectWith({"first", "second"})) continue;
    comparisons.push_back({node.id("first"), node.id("second")});
  }
  return comparisons;
}

Family readFamily(const Node& node) {
  Family family;
  if (!node.isObjectWith(
          {"id", "title", "instrument", "blocks", "comparisons", "test", "correction", "alpha"})) {
    return family;
  }
  family.id = node.id("id");
  family.title = node.text("title");
  family.instrument = node.id("instrument");
  family.blocks = node.ids("blocks");
  family.comparisons = readComparisons(node);
  family.test = node.choice("test", kTests);
  family.correction = node.choice("correction", kCorrections);
  family.alpha = node.number("alpha", 0.0, 1.0);
  if (family.alpha == 0.0 || family.alpha == 1.0) {
    node.problem("alpha", "alpha must lie between 0 and 1, both excluded", "0.05 is usual");
  }
  return family;
}

SimulationTruth readSimulation(const Node& node) {
  SimulationTruth truth;
  if (!node.isObjectWith(
          {"realism", "person_deviation", "person_by_condition_deviation", "answer_deviation"})) {
    return truth;
  }
  if (const auto realism = node.object("realism")) {
    for (const auto& [condition, unused] : realism->members()) {
      truth.realismByCondition.emplace_back(condition, realism->number(condition, -10.0, 10.0));
    }
  }
  truth.personDeviation = node.number("person_deviation", 0.0, 10.0, truth.personDeviation);
  truth.personByConditionDeviation =
      node.number("person_by_condition_deviation", 0.0, 10.0, truth.personByConditionDeviation);
  truth.answerDeviation = node.number("answer_deviation", 0.0, 10.0, truth.answerDeviation);
  return truth;
}

template <typename T, typename Read>
std::vector<T> readAll(const std::vector<Node>& nodes, Read read) {
  std::vector<T> all;
  for (const auto& node : nodes) all.push_back(read(node));
  return all;
}

}  // namespace

std::optional<Protocol> readProtocol(std::string_view json, questionnaires::Problems& problems) {
  const auto value = questionnaires::parseJson(json, problems);
  if (!value) return std::nullopt;
  const Node root(*value, "$", problems);
  if (!root.isObjectWith(
          {"$schema",
           "study",
           "languages",
           "seed",
           "cohorts",
           "devices",
           "instrument_files",
           "conditions",
           "labels",
           "phases",
           "analysis",
           "simulation"})) {
    return std::nullopt;
  }
  requireSchema(root);
  Protocol protocol;
  if (const auto study = root.requiredObject("study")) protocol.study = readMetadata(*study);
  for (const auto& language : root.requiredList("languages")) {
    protocol.languages.push_back(language.asText());
  }
  if (root.has("seed")) {
    protocol.seed = static_cast<std::uint64_t>(root.wholeNumber("seed", 0, kMostExactWhole));
  }
  protocol.cohorts = readAll<Cohort>(root.requiredList("cohorts"), readCohort);
  protocol.devices = readAll<DeviceNeed>(root.requiredList("devices"), readDevice);
  protocol.instrumentFiles = root.texts("instrument_files");
  protocol.conditions = readAll<Condition>(root.requiredList("conditions"), readCondition);
  protocol.labels = readLabels(root);
  protocol.phases = readAll<Phase>(root.requiredList("phases"), readPhase);
  if (const auto analysis = root.object("analysis")) {
    if (analysis->isObjectWith({"families"})) {
      protocol.analysis.families = readAll<Family>(analysis->requiredList("families"), readFamily);
    }
  }
  if (const auto truth = root.object("simulation")) protocol.simulation = readSimulation(*truth);
  return problems.hasErrors() ? std::nullopt : std::optional(std::move(protocol));
}

}  // namespace protocols
