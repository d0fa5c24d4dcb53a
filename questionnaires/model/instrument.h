#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "questionnaires/json/document.h"
#include "questionnaires/json/problem.h"

namespace questionnaires {

/// A text in several languages, by language tag ("en", "de", "nb").
class LocalizedText {
 public:
  LocalizedText() = default;
  explicit LocalizedText(std::map<std::string, std::string> byLanguage)
      : byLanguage_(std::move(byLanguage)) {}

  /// The text in @p language, or in English if that language is missing; empty if both are missing.
  const std::string& in(std::string_view language) const;

  bool has(std::string_view language) const { return byLanguage_.count(std::string(language)) > 0; }
  bool operator==(const LocalizedText& other) const = default;
  bool isEmpty() const noexcept { return byLanguage_.empty(); }
  const std::map<std::string, std::string>& all() const noexcept { return byLanguage_; }

 private:
  std::map<std::string, std::string> byLanguage_;
};

/// The type of an item: how it is presented and answered.
enum class ItemType {
  Likert,                ///< agreement with a statement, on a scale of points
  SemanticDifferential,  ///< a point of a scale between two opposite words
  Slider,                ///< a value between two ends; the handle appears when the participant
                         ///< touches the slider
  SingleChoice,          ///< one of several options
  MultipleChoice,        ///< any number of options, possibly none
  Number,
  ShortText,       ///< text of one line
  LongText,        ///< text of several lines
  PairwiseChoice,  ///< one of two options
};

/// The kind of value that answers an item.
enum class AnswerKind {
  Point,    ///< a point of its scale
  Number,   ///< a number from `least` to `most`
  Option,   ///< the id of one of its options
  Options,  ///< the ids of any number of its options
  Text,
};

/// The facts on a type of item: its name in files and exports, and the kind of its answers.
struct ItemTypeFacts {
  std::string_view name;
  ItemType value;
  AnswerKind answer;
};
/// All types of items, in the order of ItemType.
inline constexpr std::array kItemTypes{
    ItemTypeFacts{"likert", ItemType::Likert, AnswerKind::Point},
    ItemTypeFacts{"semantic_differential", ItemType::SemanticDifferential, AnswerKind::Point},
    ItemTypeFacts{"slider", ItemType::Slider, AnswerKind::Number},
    ItemTypeFacts{"single_choice", ItemType::SingleChoice, AnswerKind::Option},
    ItemTypeFacts{"multiple_choice", ItemType::MultipleChoice, AnswerKind::Options},
    ItemTypeFacts{"number", ItemType::Number, AnswerKind::Number},
    ItemTypeFacts{"short_text", ItemType::ShortText, AnswerKind::Text},
    ItemTypeFacts{"long_text", ItemType::LongText, AnswerKind::Text},
    ItemTypeFacts{"pairwise_choice", ItemType::PairwiseChoice, AnswerKind::Option},
};

static_assert(
    [] {
      for (std::size_t i = 0; i < kItemTypes.size(); ++i) {
        if (kItemTypes[i].value != static_cast<ItemType>(i)) return false;
      }
      return true;
    }(),
    "in the order of ItemType");

AnswerKind answerKindOf(ItemType type) noexcept;
std::string_view nameOf(ItemType type) noexcept;

/// A scale of whole-numbered points, from `lowest` to highest().
struct Scale {
  int lowest = 1;
  int points = 5;
  LocalizedText lowLabel;                  ///< label of the lowest point
  LocalizedText highLabel;                 ///< label of the highest point
  std::vector<LocalizedText> pointLabels;  ///< a label for each point, or empty

  int highest() const noexcept { return lowest + points - 1; }
  bool operator==(const Scale& other) const = default;
};

/// The smallest and largest number of points of a scale.
inline constexpr int kFewestPoints = 2;
inline constexpr int kMostPoints = 101;

/// The largest sizes of an instrument.
inline constexpr std::size_t kMostItems = 1000;
inline constexpr std::size_t kMostScores = 1000;
inline constexpr std::size_t kMostOptions = 1000;

/// The default maximum length of a text answer [characters].
inline constexpr std::int64_t kLongestShortText = 500;
inline constexpr std::int64_t kLongestLongText = 100'000;

/// An option of a choice.
struct Option {
  std::string id;
  LocalizedText text;
};

/// Where an item's options come from.
enum class OptionSource {
  Listed,        ///< listed in the instrument
  Alternatives,  ///< the alternatives that the participant has felt in a block
};

/// The thing with which a statement compares an alternative.
enum class Reference {
  None,
  Previous,  ///< with the alternative felt before ("than the previous cut")
};

/// What a study must have so that a question about it can be answered. If the study lacks it, the
/// check of the protocol reports this.
enum class StudyFeature {
  None,
  Benchmark,  ///< cuts with the physical tool in an earlier phase
  Vibration,  ///< vibration and chatter of the tool
  Pace,       ///< how fast material is removed
  ForceSize,  ///< how large the forces are, compared with those of an operation
};

/// The names of StudyFeature in files and messages.
inline constexpr std::array kStudyFeatures{
    Choice<StudyFeature>{"benchmark", StudyFeature::Benchmark},
    Choice<StudyFeature>{"vibration", StudyFeature::Vibration},
    Choice<StudyFeature>{"pace", StudyFeature::Pace},
    Choice<StudyFeature>{"force_size", StudyFeature::ForceSize},
};

/// The texts of an item that an instrument may withhold, so that a wording file must supply them.
enum class WordingField { Text, LowLabel, HighLabel, LeftLabel, RightLabel };

/// The condition of an item: it is asked only after certain answers to an earlier item.
struct ShowIf {
  std::string item;  ///< id of an earlier choice item; empty if the item is always asked
  std::vector<std::string> wantedOptions;  ///< ids of options of that item; one of them must have
                                           ///< been chosen

  bool isSet() const noexcept { return !item.empty(); }
};

/// One question.
struct Item {
  std::string id;
  ItemType type = ItemType::Likert;
  LocalizedText text;  ///< may be empty for a SemanticDifferential
  /// Name of the item set to which it belongs; a phase may ask for one set only.
  std::string set;
  int key = 1;  ///< +1: a high answer is good; -1: a low answer is good, so the item is
                ///< reverse-keyed
  bool isRequired = true;
  /// Whether the answer identifies a person; it is then stored in identity.db and never exported.
  bool isIdentifying = false;
  bool startsPage = false;  ///< whether the item begins a new page
  ShowIf showIf;
  Reference comparedWith = Reference::None;
  StudyFeature neededFeature = StudyFeature::None;

  Scale scale;              ///< Likert, SemanticDifferential
  LocalizedText leftText;   ///< SemanticDifferential, Slider: label of the low end
  LocalizedText rightText;  ///< SemanticDifferential, Slider: label of the high end
  double least = 0.0;       ///< Slider, Number: smallest answer
  double most = 100.0;      ///< Slider, Number: largest answer
  double step = 1.0;        ///< Slider, Number: step between answers; 0: any value is allowed
  std::string unit;         ///< Number: symbol of the unit, the same in every language
  OptionSource optionSource = OptionSource::Listed;
  std::vector<Option> options;  ///< SingleChoice, MultipleChoice, PairwiseChoice
  std::string consentOption;    ///< SingleChoice: id of the option that gives consent; empty if the
                                ///< item does not ask for consent
  /// ShortText, LongText: maximum length [characters]; 0: kLongestShortText or kLongestLongText.
  std::int64_t longestAnswer = 0;

  /// The smallest acceptable answer, after reversal by the key; std::nullopt without a threshold.
  /// For Likert, SemanticDifferential, Slider, Number.
  std::optional<double> acceptableFrom;
  /// The texts that may not be shipped with the instrument; a wording file in the protocol's folder
  /// must supply them. For Likert, SemanticDifferential, Slider.
  std::vector<WordingField> withheld;

  bool withholds(WordingField field) const noexcept;
};

/// A score: one number computed from the answers to several items. An unanswered item is missing;
/// it is not replaced by the midpoint or zero.
struct Score {
  enum class Aggregate {
    Mean,   ///< Σ w x / Σ w; without weights w = 1
    Sum,    ///< Σ w x
    Count,  ///< number of answers of at least countFrom
  };

  std::string id;
  LocalizedText title;
  std::vector<std::string> items;
  Aggregate aggregate = Aggregate::Mean;
  /// Whether an answer x to an item with key -1 is replaced by low + high - x.
  bool reverseByKey = true;
  /// Smallest number of answered items for a Mean, or for any score with missingAs; 0: all items
  /// must be answered.
  std::size_t leastAnswered = 0;
  double offset = 0.0;          ///< added to the aggregate
  double factor = 1.0;          ///< multiplies (aggregate + offset)
  double countFrom = 0.0;       ///< Count: the smallest answer that is counted
  std::vector<double> weights;  ///< Mean, Sum: a weight ≥ 0 for each item; or empty
  /// Mean, Sum: ids of pairwise choices whose options have the ids of the items. The weight of an
  /// item is the number of times it was chosen.
  std::vector<std::string> weightsFrom;
  /// The value (before reversal) that replaces a missing answer if at least leastAnswered items
  /// were answered; std::nullopt: missing answers are not replaced.
  std::optional<double> missingAs;

  bool operator==(const Score&) const = default;
};

/// A rule for finding suspicious answers of a person: answers that contradict each other.
struct ConsistencyRule {
  std::vector<std::string> scores;  ///< ids of the checked scores
  /// The largest range of keyed answers to the items of one score that is no contradiction.
  double widestRange = 0.0;
  /// Smallest number of contradictory scores for which the answers are suspicious.
  std::size_t suspiciousFrom = 1;
};

/// How often an instrument is answered for one result.
enum class Occasions {
  Once,
  BeforeAndAfter,  ///< twice; the result is the change between both
};

/// The source and licence of an instrument.
struct Source {
  std::string citation;
  std::string doi;
  std::string licence;
  /// Further notes for researchers, for example on its author or on changes.
  std::string note;
  std::string wordingFrom;  ///< where researchers can get the withheld texts
};

/// A questionnaire as its author published it: items, scales, keys and scoring, in several
/// languages. An instrument without items is an information text.
struct Instrument {
  std::string id;
  std::string version;
  LocalizedText title;  ///< may be shown to participants
  /// Text above the items; or the text of an information or consent form.
  LocalizedText introduction;
  Source source;
  std::vector<std::string> languages;
  std::optional<Scale> scale;  ///< scale of items that have none of their own
  std::vector<Item> items;
  std::vector<Score> scores;
  Occasions occasions = Occasions::Once;
  std::optional<ConsistencyRule> consistency;

  const Item* item(std::string_view id) const noexcept;
  /// The items of @p set in order; all items if @p set is empty.
  std::vector<Item> itemsOf(std::string_view set) const;
  const Score* score(std::string_view id) const noexcept;
  /// Whether some of its texts must come from a wording file (questionnaires/reading/wording.h).
  bool hasWithheldTexts() const noexcept;
};

/// The problems of @p instrument as a whole: duplicate ids, scores of items that do not exist,
/// texts that lack a language. Warns of statements that compare with the previous alternative, and
/// of placeholders "[[…]]" that are not filled in. The reader checks types and spelling of keys;
/// wording.h checks that withheld texts are supplied.
Problems problemsOf(const Instrument& instrument);

/// A range of answers, both ends included.
struct Range {
  double low = 0.0;
  double high = 0.0;

  bool operator==(const Range& other) const = default;
};

/// The range of valid answers to @p item; std::nullopt if they are not numbers.
std::optional<Range> rangeOf(const Item& item) noexcept;

}  // namespace questionnaires
