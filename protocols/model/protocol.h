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
  double maxForce = 0.0;               ///< [N]
  double maxForceRate = 0.0;           ///< [N/s]
  double maxVelocity = 300.0;          ///< beyond it nobody holds the tool [device's travel unit/s]
  bool isPassivityControlled = false;  ///< damped where a scene gives more energy than it took
};

/// The name of the cut that ships.
inline constexpr std::string_view kParametricCut = "parametric";

/// Where a force model's parameters come from that stand in no protocol: a cut, by name or file.
struct CutReference {
  std::string name;  ///< kParametricCut, or a cut file beside the protocol
  std::string path;  ///< JSON path of the reference, for messages
};

/// Where a fitted reaming material comes from.
struct MaterialReference {
  std::string name;  ///< a material file beside the protocol
  haptics::reaming::TestSet set = haptics::reaming::TestSet::Dynamic1;
  bool hasJitter = false;  ///< what its low-pass took out is put back as noise
  std::string path;        ///< JSON path of the reference, for messages
};

/// The name of the bone that ships.
inline constexpr std::string_view kParametricBone = "parametric";

/// Where a bone of spheres comes from.
struct PackingReference {
  std::string name;  ///< kParametricBone, or a packing file beside the protocol
  std::string path;  ///< JSON path of the reference, for messages
};

struct Anatomy;

/// Where the knee comes from that is seen, in place of ours.
struct AnatomyReference {
  std::string name;  ///< an OBJ file beside the protocol
  std::string path;  ///< JSON path of the reference, for messages
};

/// One rendering that may be felt: the device and a scene, complete but for what lies in other
/// files.
struct Condition {
  std::string id;
  std::string title;  ///< for researchers; participants see an alternative
  std::string device;
  haptics::engine::SceneSpec scene;
  std::optional<MaterialReference> material;  ///< where a bone's curves are taken from
  bool hasOwnMaterial = false;                ///< a bone that names none: it is the program's
  std::optional<PackingReference> packing;    ///< where a bone's spheres are taken from
  std::optional<CutReference> cut;            ///< where the scene's curve is taken from
  std::optional<AnatomyReference> anatomy;    ///< where the knee that is seen is taken from
  std::shared_ptr<const Anatomy> knee;        ///< that anatomy; nothing: ours
};

/// Which label an alternative bears.
enum class LabelPolicy {
  Condition,  ///< a condition has the same label for everybody, as in the punch paper
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

/// Trials that belong together: every condition once, in somebody's order.
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
