#pragma once

#include <cstdint>
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

/// What a study is, for people and catalogues.
struct StudyMetadata {
  std::string id;
  std::string title;
  std::string version;
  std::vector<std::string> authors;
  std::vector<std::string> organizations;
  std::string date;  ///< ISO 8601
  std::string description;
};

/// A group of participants by what they are.
struct Cohort {
  std::string id;
  LocalizedText title;
  int planned = 0;  ///< how many participants; 0: not said
};

/// An instrument that the study needs, and how hard it may ever push.
struct DeviceNeed {
  std::string id;
  const haptics::devices::DeviceKind* kind;
  double maxForce = 0.0;       ///< [N]
  double maxForceRate = 0.0;   ///< [N/s]
  double maxVelocity = 300.0;  ///< beyond it the tool is in no hand [device's travel unit/s]
  bool isPassivityControlled = false;  ///< damped where a scene gives more energy than it took
};

/// The name of the cut that ships.
inline constexpr std::string_view kParametricCut = "parametric";

/// The name of the bone of spheres that ships.
inline constexpr std::string_view kParametricBone = "parametric";

struct Anatomy;

/// One rendering that may be felt: a device, and what is felt and seen on it.
struct Condition {
  std::string id;
  std::string title;  ///< for researchers; participants see an alternative
  std::string device;
  /// Complete, with all that its files hold. Nothing only while a protocol is read, where the model
  /// could not be: a protocol that was loaded has all of them.
  std::optional<haptics::engine::ModelSpec> model;
  bool isVisualised = false;
  haptics::engine::SeenTissue seenTissue = haptics::engine::SeenTissue::Penetration;
  std::optional<std::string> anatomy;   ///< the file of the knee that is seen, in place of ours
  std::shared_ptr<const Anatomy> knee;  ///< what that file holds; nothing: ours

  /// What is felt and seen. @pre there is a model.
  haptics::engine::SceneSpec scene() const { return {*model, isVisualised, seenTissue}; }
};

/// Which label an alternative bears.
enum class LabelPolicy {
  Condition,  ///< a condition has the same label for all, as in the punch paper
  Position,   ///< what comes first is Alternative 1
  Random,     ///< drawn for every participant
};

struct Labels {
  LabelPolicy policy = LabelPolicy::Position;
  LocalizedText prefix;  ///< "Alternative"
};

/// How a block's conditions follow each other.
enum class OrderType {
  Fixed,                ///< as written
  Reversed,             ///< another block's, backwards
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
  /// Which set of items for which condition; all items where a condition is not named.
  std::vector<std::pair<std::string, std::string>> setByCondition;

  std::string setFor(std::string_view condition) const;
};

/// Trials that belong together: every condition once, in the participant's order.
struct Block {
  std::vector<std::string> conditions;
  std::optional<bool> isVisualised;  ///< instead of what the conditions say
  Order order;
  int minimumCuts = 0;  ///< a trial lasts at least so many cuts (strokes)
  std::vector<ConditionQuestionnaire> questionnaires;  ///< after each condition
};

enum class PhaseType {
  Information,  ///< something to read
  Consent,      ///< something to agree to; nothing is felt before it
  Form,         ///< a questionnaire, once
  Benchmark,    ///< the real thing, on the physical tool
  Block,        ///< trials
  Preference,   ///< which of a block's alternatives
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
  double seconds = 0.0;       ///< Break: lasts at least so long [s]; 0: as long as they like
  Block trials;               ///< Block
  std::string block;          ///< Preference: between the alternatives of this one
  bool mayFeelAgain = false;  ///< Preference: each of them is offered once more before
};

/// Which pairs of conditions are compared.
struct Comparison {
  std::string first;
  std::string second;
};

/// Which test a family declares: its result is confirmatory, all others are exploratory.
enum class TestType {
  Welch,       ///< of all answers, pooled, as in the punch paper
  PairedT,     ///< of participants' means
  SignFlip,    ///< … exact, by turning round the signs of the differences
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

/// Comparisons that belong together: their number corrects each of them.
struct Family {
  std::string id;
  std::string title;
  std::string instrument;           ///< whose keyed Likert answers are compared
  std::vector<std::string> blocks;  ///< from which; all that ask this instrument where empty
  std::vector<Comparison> comparisons;
  TestType test = TestType::Welch;
  CorrectionType correction = CorrectionType::Bonferroni;
  double alpha = 0.05;
  /// Means that differ by less are the same for all that matters [points of the scale].
  std::optional<double> equivalenceBound;
};

struct AnalysisPlan {
  std::vector<Family> families;
};

/// What a simulated cohort feels, on a scale where 0 is the middle of the questionnaire: for trying
/// a protocol out before anybody comes. Never a finding.
struct SimulationTruth {
  std::vector<std::pair<std::string, double>> realismByCondition;
  double personDeviation = 0.5;             ///< how lenient people are
  double personByConditionDeviation = 0.5;  ///< how tastes differ
  double answerDeviation = 0.8;             ///< how one answer differs from the next

  double realismOf(std::string_view condition) const;
};

/// A study, as a researcher wrote it.
struct Protocol {
  StudyMetadata study;
  std::vector<std::string> languages;
  std::optional<std::uint64_t> seed;
  std::vector<Cohort> cohorts;
  std::vector<DeviceNeed> devices;
  std::vector<std::string> instrumentFiles;  ///< beside the protocol; the library is always there
  std::vector<Condition> conditions;
  Labels labels;
  std::vector<Phase> phases;
  AnalysisPlan analysis;
  SimulationTruth simulation;

  const Condition* condition(std::string_view id) const noexcept;
  const DeviceNeed* device(std::string_view id) const noexcept;
  /// Of all devices; nullptr where there are several kinds.
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
