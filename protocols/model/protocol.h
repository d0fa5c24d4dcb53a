#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "haptics/devices/device_kind.h"
#include "haptics/engine/scene_spec.h"
#include "questionnaires/model/instrument.h"

namespace protocols {

using questionnaires::LocalizedText;

/// Facts about a study for readers and catalogues.
struct StudyMetadata {
  std::string id;
  std::string title;
  std::string version;
  std::vector<std::string> authors;
  std::vector<std::string> organizations;
  std::string date;  ///< ISO 8601
  std::string description;
};

/// A group of participants.
struct Cohort {
  std::string id;
  LocalizedText title;
  int planned = 0;  ///< planned number of participants; 0: not given
};

/// A device that the study needs, and its limits.
struct DeviceNeed {
  std::string id;
  const haptics::devices::DeviceKind* kind;
  double maxForce = 0.0;        ///< [N]
  double maxForceRate = 0.0;    ///< [N/s]
  double maxTorque = 5.0;       ///< about the tool's axis [N·m]
  double maxTorqueRate = 50.0;  ///< [N·m/s]
  bool isTorqueAsked = false;   ///< a scene on this device has a torque about the tool's axis
  double maxVelocity = 300.0;   ///< above it the tool has slipped from the hand [device's travel
                                ///< unit/s]
  bool isPassivityControlled = false;  ///< damping is added if a scene generates energy
};

/// The name of the built-in cut.
inline constexpr std::string_view kParametricCut = "parametric";

/// The name of the built-in bone of spheres.
inline constexpr std::string_view kParametricBone = "parametric";

struct Anatomy;

/// A condition: a device, and the scene on it.
struct Condition {
  std::string id;
  std::string title;  ///< for researchers; participants see an alternative
  std::string device;
  /// Complete, with the content of its files. std::nullopt only while a protocol with errors is
  /// read; every loaded protocol has all models.
  std::optional<haptics::engine::ModelSpec> model;
  bool isVisualised = false;
  haptics::engine::SeenTissue seenTissue = haptics::engine::SeenTissue::Penetration;
  haptics::engine::Reamer reamer;       ///< of bone that is removed
  std::optional<std::string> anatomy;   ///< file of the knee that is shown, in place of the
                                        ///< built-in one
  std::shared_ptr<const Anatomy> knee;  ///< content of that file; nullptr: the built-in knee

  /// The scene to render and show. @pre model has a value.
  haptics::engine::SceneSpec scene() const { return {*model, isVisualised, seenTissue, reamer}; }
};

/// How alternatives are labelled.
enum class LabelPolicy {
  Condition,  ///< a condition has the same label for all, as in the punch paper
  Position,   ///< the first one is Alternative 1
  Random,     ///< drawn for every participant
};

struct Labels {
  LabelPolicy policy = LabelPolicy::Position;
  LocalizedText prefix;  ///< "Alternative"

  /// What an alternative is called: "Alternative 2".
  std::string nameOf(std::string_view number, std::string_view language) const {
    return prefix.in(language) + ' ' + std::string(number);
  }
};

/// How the order of a block's conditions is determined.
enum class OrderType {
  Fixed,                ///< as written
  Reversed,             ///< another block's, reversed
  Random,               ///< drawn for every participant
  LatinSquare,          ///< every condition equally often at every position
  BalancedLatinSquare,  ///< … and equally often after every other (Williams 1949)
  Complete,             ///< all orders equally often
};

struct Order {
  OrderType type = OrderType::Fixed;
  std::string of;  ///< Reversed: the block
};

/// Questions after each condition of a block.
struct ConditionQuestionnaire {
  std::string instrument;
  /// The set of items for each condition; all items for conditions that are not named.
  std::vector<std::pair<std::string, std::string>> setByCondition;

  std::string setFor(std::string_view condition) const;
};

/// Trials with every condition once, in the participant's order.
struct Block {
  std::vector<std::string> conditions;
  std::optional<bool> isVisualised;  ///< overrides the conditions
  Order order;
  int minimumCuts = 0;  ///< smallest number of cuts (strokes) in a trial
  std::vector<ConditionQuestionnaire> questionnaires;  ///< after each condition
};

enum class PhaseType {
  Information,  ///< something to read
  Consent,      ///< consent; no trial is allowed before it
  Form,         ///< a questionnaire, once
  Benchmark,    ///< cuts with the physical tool
  Block,        ///< trials
  Preference,   ///< a choice between a block's alternatives
  Break,
  Interview,  ///< the operator writes
  Debrief,    ///< something to read at the end
};

/// A part of a session.
struct Phase {
  std::string id;
  PhaseType type = PhaseType::Information;
  std::string instrument;     ///< of all but Block, Benchmark and Break
  LocalizedText text;         ///< Benchmark, Break: what the participant reads
  int minimumCuts = 0;        ///< Benchmark
  double seconds = 0.0;       ///< Break: minimum duration [s]; 0: as long as the participant likes
  Block trials;               ///< Block
  std::string block;          ///< Preference: between the alternatives of this one
  bool mayFeelAgain = false;  ///< Preference: each of them is offered once more before the choice
};

/// A pair of conditions to compare.
struct Comparison {
  std::string first;
  std::string second;
};

/// Which test a family declares: its result is confirmatory, all others are exploratory.
enum class TestType {
  Welch,       ///< of all answers, pooled, as in the punch paper
  PairedT,     ///< of participants' means
  SignFlip,    ///< … exact, by all signs of the differences
  SignedRank,  ///< … Wilcoxon's, exact
};
enum class CorrectionType {
  None,
  Bonferroni,
  Holm,
  Hochberg,
  Hommel,
  BenjaminiHochberg,
  BenjaminiYekutieli,
  HolmSidak,
};

/// Comparisons that share one alpha; p values are adjusted for their number.
struct Family {
  std::string id;
  std::string title;
  std::string instrument;          ///< its answers are compared, reversed where the key is −1
  std::vector<std::string> items;  ///< those that are compared, on one scale (see
                                   ///< comparedItems()); empty: all Likert items
  std::string
      score;  ///< of the instrument: compared in place of items, as it is computed; or empty
  std::vector<std::string> blocks;  ///< those whose answers count; empty: all that ask this
                                    ///< instrument
  std::vector<Comparison> comparisons;
  TestType test = TestType::Welch;
  CorrectionType correction = CorrectionType::Bonferroni;
  double alpha = 0.05;
  /// Smaller differences of means are negligible [points of the scale].
  std::optional<double> equivalenceBound;
};

/// Those of @p items that @p family compares, in their order; none if it compares a score.
std::vector<questionnaires::Item> comparedItems(
    const Family& family, const std::vector<questionnaires::Item>& items);

/// The scale of answers that a family compares.
struct ComparedScale {
  double lowest = 1.0;
  double highest = 5.0;
  /// Whole numbers that can be counted point by point: both ends and the step are whole, and there
  /// are at most kMostComparedPoints.
  bool isOfPoints = true;

  bool operator==(const ComparedScale&) const = default;
};

/// The most points of a scale that are counted: those of analysis::LikertCounts.
inline constexpr int kMostComparedPoints = 1024;

/// The points of an item, or the range of a slider or a number; std::nullopt for all others.
std::optional<ComparedScale> scaleOf(const questionnaires::Item& item);

/// The scale of a family: of its score, or of the first of its items; std::nullopt if it has none
/// of these.
std::optional<ComparedScale> scaleOf(
    const Family& family, const questionnaires::Instrument& instrument);

struct AnalysisPlan {
  std::vector<Family> families;
};

/// How a simulated cohort answers, on a scale where 0 is the middle of the questionnaire. Only for
/// trying a protocol out.
struct SimulationTruth {
  std::vector<std::pair<std::string, double>> realismByCondition;
  double personDeviation = 0.5;             ///< between participants
  double personByConditionDeviation = 0.5;  ///< of a participant's opinion on a condition
  double answerDeviation = 0.8;             ///< between answers

  double realismOf(std::string_view condition) const;
};

/// A study, as a researcher wrote it.
struct Protocol {
  StudyMetadata study;
  std::vector<std::string> languages;
  std::optional<std::uint64_t> seed;
  bool isBlindingOpen = false;  ///< conditions are not hidden from anyone
  std::vector<Cohort> cohorts;
  std::vector<DeviceNeed> devices;
  std::vector<std::string> instrumentFiles;  ///< beside the protocol; the library needs no entry
  /// What the laboratory has written for the blanks "[[key]]" of its texts, by key.
  std::map<std::string, LocalizedText> texts;
  std::vector<Condition> conditions;
  Labels labels;
  std::vector<Phase> phases;
  AnalysisPlan analysis;
  SimulationTruth simulation;

  const Condition* condition(std::string_view id) const noexcept;
  const DeviceNeed* device(std::string_view id) const noexcept;
  /// The kind of all devices; nullptr if there are several kinds.
  const haptics::devices::DeviceKind* onlyDeviceKind() const noexcept;
  const Phase* phase(std::string_view id) const noexcept;
  const Cohort* cohort(std::string_view id) const noexcept;
};

/// A place where a protocol names an instrument.
struct InstrumentUse {
  std::string instrument;
  std::string path;  ///< of the name: "$.phases[1].instrument"
  PhaseType phase = PhaseType::Information;
};

/// All of them, in the order of the session.
std::vector<InstrumentUse> instrumentUses(const Protocol& protocol);

}  // namespace protocols
