#pragma once

#include <array>
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

/// The languages of the program's own texts in participants' windows (study/words/library). Texts
/// of a protocol and of its questionnaires may be in other languages.
inline constexpr std::array<std::string_view, 3> kWindowLanguages{"en", "de", "nb"};

/// Metadata of a study for readers and catalogues.
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
  int planned = 0;  ///< planned number of participants; 0 if not given
};

/// A device that the study needs, with its limits.
struct DeviceRequirement {
  std::string id;
  const haptics::devices::DeviceKind* kind;
  double maxForce = 0.0;        ///< force limit [N]
  double maxForceRate = 0.0;    ///< limit of the rate of the force [N/s]
  double maxTorque = 5.0;       ///< limit of the torque about the tool's axis [N·m]
  double maxTorqueRate = 50.0;  ///< limit of the rate of the torque [N·m/s]
  bool needsTorque = false;     ///< whether a scene on this device has a torque about the tool's
                                ///< axis
  double maxVelocity = 300.0;   ///< at a higher speed the tool is assumed to have slipped from the
                                ///< hand [travel unit of the device/s]
  bool isPassivityControlled = false;  ///< whether damping is added if a scene generates energy
};

/// The name of the built-in cut.
inline constexpr std::string_view kParametricCut = "parametric";

/// The name of the built-in bone of spheres.
inline constexpr std::string_view kParametricBone = "parametric";

struct Anatomy;

/// A condition: a device, and the scene that it renders.
struct Condition {
  std::string id;
  std::string title;  ///< title for researchers; participants read the label of an alternative
  std::string device;
  /// The force model, with the content of its files. std::nullopt only while a protocol with errors
  /// is read; every condition of a loaded protocol has a model.
  std::optional<haptics::engine::ModelSpec> model;
  bool isVisualised = false;  ///< whether the scene is shown; a block may override it
  haptics::engine::TissueDrawing tissueDrawing = haptics::engine::TissueDrawing::Penetration;
  haptics::engine::Reamer reamer;       ///< limits the removal of bone
  std::optional<std::string> anatomy;   ///< file of a knee that replaces the displayed built-in one
  std::shared_ptr<const Anatomy> knee;  ///< content of that file; nullptr for the built-in knee

  /// The scene to render and show. @pre model has a value.
  haptics::engine::SceneSpec scene() const { return {*model, isVisualised, tissueDrawing, reamer}; }
};

/// How the labels of alternatives are chosen.
enum class LabelPolicy {
  Condition,  ///< each condition has one label for all participants, as in the punch paper
  Position,   ///< the label is the position: the condition that is felt first is Alternative 1
  Random,     ///< drawn separately for every participant
};

/// How a protocol labels alternatives.
struct Labels {
  LabelPolicy policy = LabelPolicy::Position;
  LocalizedText prefix;  ///< "Alternative"

  /// The label of an alternative as participants read it: "Alternative 2".
  std::string nameOf(std::string_view number, std::string_view language) const {
    return prefix.in(language) + ' ' + std::string(number);
  }
};

/// How the order of a block's conditions is determined.
enum class OrderType {
  Fixed,                ///< as written in the protocol
  Reversed,             ///< another block's order, reversed
  Random,               ///< drawn separately for every participant
  LatinSquare,          ///< every condition equally often at every position
  BalancedLatinSquare,  ///< as LatinSquare, and equally often after every other condition (Williams
                        ///< 1949)
  Complete,             ///< all orders equally often
};

/// The rule for the order of a block's conditions.
struct Order {
  OrderType type = OrderType::Fixed;
  std::string of;  ///< Reversed: id of the other block
};

/// Questions after each condition of a block.
struct ConditionQuestionnaire {
  std::string instrument;
  /// The item set for a condition; conditions that are not listed get all items.
  std::vector<std::pair<std::string, std::string>> setByCondition;

  std::string itemSetFor(std::string_view condition) const;
};

/// A block of trials: every condition once, in the order of the participant.
struct Block {
  std::vector<std::string> conditions;
  std::optional<bool> isVisualised;  ///< overrides Condition::isVisualised
  Order order;
  int minimumCuts = 0;  ///< smallest number of cuts or strokes in a trial
  std::vector<ConditionQuestionnaire> questionnaires;  ///< after each condition
};

/// The type of a part of a session.
enum class PhaseType {
  Information,  ///< a text to read
  Consent,      ///< consent form; no trial is allowed before it
  Form,         ///< a questionnaire, once
  Benchmark,    ///< cuts with the physical tool
  Block,        ///< trials
  Preference,   ///< a choice between a block's alternatives
  Break,
  Interview,  ///< the operator writes down answers
  Debrief,    ///< a text to read at the end
};

/// A part of a session.
struct Phase {
  std::string id;
  PhaseType type = PhaseType::Information;
  std::string instrument;  ///< id; for all types except Block, Benchmark and Break
  LocalizedText text;      ///< Benchmark, Break: text for the participant
  int minimumCuts = 0;     ///< Benchmark: smallest number of cuts
  double seconds = 0.0;    ///< Break: minimum duration [s]; 0 for none
  Block trials;            ///< Block
  std::string block;       ///< Preference: id of the block whose alternatives are offered
  /// Preference: whether each alternative can be felt again before the choice.
  bool hasOptionalTrials = false;
};

/// A pair of conditions to compare.
struct Comparison {
  std::string first;
  std::string second;
};

/// The test that a family declares. Its result is confirmatory; all others are exploratory.
enum class TestType {
  Welch,       ///< Welch's t-test on all answers, pooled, as in the punch paper
  PairedT,     ///< paired t-test on participants' means
  SignFlip,    ///< exact sign-flip test on participants' means
  SignedRank,  ///< Wilcoxon's exact signed-rank test on participants' means
};
/// The adjustment of p values for the number of comparisons of a family.
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

/// A family of comparisons with one significance level; p values are adjusted for their number.
struct Family {
  std::string id;
  std::string title;
  /// Id of the instrument whose answers are compared, reversed for a key of −1.
  std::string instrument;
  std::vector<std::string> items;  ///< ids of the compared items, which share one scale (see
                                   ///< comparedItems()); empty for all Likert items
  /// Id of a score of the instrument that is compared instead of items; empty for none.
  std::string score;
  std::vector<std::string> blocks;  ///< ids of the blocks whose answers are used; empty for all
                                    ///< blocks that ask this instrument
  std::vector<Comparison> comparisons;
  TestType test = TestType::Welch;
  CorrectionType correction = CorrectionType::Bonferroni;
  double alpha = 0.05;  ///< significance level of the whole family
  /// Equivalence margin: smaller differences of means are considered negligible [points of the
  /// scale].
  std::optional<double> equivalenceBound;

  /// Whether it uses the answers of @p block.
  bool usesBlock(std::string_view block) const;
};

/// Those of @p items that @p family compares, in the order of @p items; empty if it compares a
/// score.
std::vector<questionnaires::Item> comparedItems(
    const Family& family, const std::vector<questionnaires::Item>& items);

/// The scale of the answers that a family compares.
struct ComparedScale {
  double lowest = 1.0;
  double highest = 5.0;
  /// Whether answers are whole numbers that can be counted by point: both ends and the step are
  /// whole numbers, and there are at most kMostComparedPoints points.
  bool isPointScale = true;

  bool operator==(const ComparedScale&) const = default;
};

/// The largest number of points of a scale whose answers can be counted:
/// analysis::LikertCounts::kMostPoints.
inline constexpr int kMostComparedPoints = 1024;

/// The points of an item's scale, or the range of a slider or number item; std::nullopt for other
/// items.
std::optional<ComparedScale> scaleOf(const questionnaires::Item& item);

/// The scale of the score that a family compares, or of its first item; std::nullopt if it has
/// neither.
std::optional<ComparedScale> scaleOf(
    const Family& family, const questionnaires::Instrument& instrument);

/// The comparisons that a protocol declares before data are collected.
struct AnalysisPlan {
  std::vector<Family> families;
};

/// Parameters of simulated answers, relative to the middle of the scale [points]. Used only to try
/// out a protocol.
struct SimulatedAnswerModel {
  std::vector<std::pair<std::string, double>> realismByCondition;  ///< mean answer, by condition id
  double participantStandardDeviation = 0.5;  ///< standard deviation between participants
  /// Standard deviation of the interaction of participant and condition.
  double interactionStandardDeviation = 0.5;
  double residualStandardDeviation = 0.8;  ///< residual standard deviation of an answer

  /// The mean answer about a condition; 0 if none is given.
  double realismOf(std::string_view condition) const;
};

/// A study as its protocol file describes it.
struct Protocol {
  StudyMetadata study;
  std::vector<std::string> languages;
  std::optional<std::uint64_t> seed;
  bool isOpenLabel = false;  ///< whether conditions are not hidden from anyone ("blinding":
                             ///< "open")
  std::vector<Cohort> cohorts;
  std::vector<DeviceRequirement> devices;
  /// Names of files in the protocol's folder; instruments of the library need no entry.
  std::vector<std::string> instrumentFiles;
  /// The laboratory's texts for the blanks "[[key]]", by key.
  std::map<std::string, LocalizedText> texts;
  std::vector<Condition> conditions;
  Labels labels;
  std::vector<Phase> phases;
  AnalysisPlan analysis;
  SimulatedAnswerModel simulation;

  /// These functions return nullptr for an unknown id.
  const Condition* condition(std::string_view id) const noexcept;
  const DeviceRequirement* device(std::string_view id) const noexcept;
  /// The common kind of all devices; nullptr if there are several kinds.
  const haptics::devices::DeviceKind* onlyDeviceKind() const noexcept;
  const Phase* phase(std::string_view id) const noexcept;
  const Cohort* cohort(std::string_view id) const noexcept;
};

/// One reference to an instrument in a protocol.
struct InstrumentUse {
  std::string instrument;
  std::string path;  ///< JSON path of the reference: "$.phases[1].instrument"
  PhaseType phase = PhaseType::Information;
};

/// All references to instruments, in the order of the session.
std::vector<InstrumentUse> instrumentUses(const Protocol& protocol);

}  // namespace protocols
