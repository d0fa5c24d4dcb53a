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

  /// The text in @p language, or in English if there is none; empty if there is neither.
  const std::string& in(std::string_view language) const;

  bool has(std::string_view language) const { return byLanguage_.count(std::string(language)) > 0; }
  bool operator==(const LocalizedText& other) const = default;
  bool isEmpty() const noexcept { return byLanguage_.empty(); }
  const std::map<std::string, std::string>& all() const noexcept { return byLanguage_; }

 private:
  std::map<std::string, std::string> byLanguage_;
};

/// How an item is answered.
enum class ItemType {
  Likert,                ///< agreement with a statement, on a scale of points
  SemanticDifferential,  ///< a point of a scale between two opposite words
  Slider,                ///< a value between two ends; shows no handle until it is touched
  SingleChoice,          ///< one of several options
  MultipleChoice,        ///< any number of several options, none included
  Number,
  ShortText,       ///< one line
  LongText,        ///< several lines
  PairwiseChoice,  ///< one of two
};

/// The kind of value that answers an item.
enum class AnswerKind {
  Point,    ///< a point of its scale
  Number,   ///< a number from `least` to `most`
  Option,   ///< the id of one of its options
  Options,  ///< the ids of any number of its options
  Text,
};

/// A type of items: its name in files and exports, and the kind of its answers.
struct ItemTypeFacts {
  std::string_view name;
  ItemType value;
  AnswerKind answer;
};
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
  LocalizedText lowLabel;                  ///< what the lowest point means
  LocalizedText highLabel;                 ///< what the highest point means
  std::vector<LocalizedText> pointLabels;  ///< one for each point, or none

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

/// The origin of an item's options.
enum class OptionSource {
  Listed,        ///< listed in the instrument
  Alternatives,  ///< the alternatives that the participant has felt in a block
};

/// What a statement compares with.
enum class Reference {
  None,
  Previous,  ///< what was felt just before ("than the previous cut")
};

/// What a question asks about besides an alternative, and what a study must therefore have. If the
/// study lacks it, the question cannot be answered, and the protocol check reports it.
enum class Referent {
  None,
  Benchmark,  ///< cuts with the physical tool in an earlier phase
  Vibration,  ///< vibration and chatter of the tool
  Pace,       ///< how fast material is removed
  ForceSize,  ///< how large the forces are, compared with those of an operation
};

/// The names of referents in files and messages.
inline constexpr std::array kReferents{
    Choice<Referent>{"benchmark", Referent::Benchmark},
    Choice<Referent>{"vibration", Referent::Vibration},
    Choice<Referent>{"pace", Referent::Pace},
    Choice<Referent>{"force_size", Referent::ForceSize},
};

/// The texts of an item that may be withheld from its instrument and supplied by a wording file.
enum class WordingField { Text, LowLabel, HighLabel, LeftLabel, RightLabel };

/// The condition of an item: it is asked only after certain answers to an earlier item.
struct ShowIf {
  std::string item;  ///< id of an earlier choice item; empty if the question is always asked
  std::vector<std::string> isIn;  ///< ids of its options; any of them fulfils the condition

  bool isSet() const noexcept { return !item.empty(); }
};

/// One question.
struct Item {
  std::string id;
  ItemType type = ItemType::Likert;
  LocalizedText text;  ///< may be empty for a SemanticDifferential
  /// Name of the set of items to which it belongs; a phase may ask for one set only.
  std::string set;
  int key = 1;  ///< +1: a high answer is good; -1: a low answer is good (reverse-keyed)
  bool isRequired = true;
  /// The answer identifies a person: stored in identity.db, never exported.
  bool isIdentifying = false;
  bool startsPage = false;  ///< whether the item begins a new page
  ShowIf showIf;
  Reference reference = Reference::None;
  Referent refersTo = Referent::None;

  Scale scale;              ///< Likert, SemanticDifferential
  LocalizedText leftText;   ///< SemanticDifferential, Slider: label of the low end
  LocalizedText rightText;  ///< SemanticDifferential, Slider: label of the high end
  double least = 0.0;       ///< Slider, Number
  double most = 100.0;      ///< Slider, Number
  double step = 1.0;        ///< Slider, Number; 0 for any value
  std::string unit;         ///< Number: symbol of the unit, the same in every language
  OptionSource optionSource = OptionSource::Listed;
  std::vector<Option> options;  ///< SingleChoice, MultipleChoice, PairwiseChoice
  std::string consentOption;    ///< SingleChoice: id of the option that gives consent; empty if the
                                ///< item does not ask for consent
  /// ShortText, LongText [characters]; 0 for kLongestShortText or kLongestLongText.
  std::int64_t longestAnswer = 0;

  /// The lowest acceptable answer, after reversal by the key; std::nullopt if there is no
  /// threshold. Likert, SemanticDifferential, Slider, Number.
  std::optional<double> acceptableFrom;
  /// The texts that may not be shipped with the instrument, and that a wording file in the
  /// protocol's folder must supply. Likert, SemanticDifferential, Slider.
  std::vector<WordingField> withheld;

  bool withholds(WordingField field) const noexcept;
};

/// The computation of one number from the answers to items. An unanswered item is missing, and is
/// not replaced by the midpoint or zero.
struct Score {
  enum class Aggregate {
    Mean,   ///< Σ w x / Σ w; without weights w = 1
    Sum,    ///< Σ w x
    Count,  ///< how many answers are at least countFrom
  };

  std::string id;
  LocalizedText title;
  std::vector<std::string> items;
  Aggregate aggregate = Aggregate::Mean;
  /// Whether an answer x to an item with key -1 is replaced by low + high - x.
  bool reverseByKey = true;
  /// Smallest number of answered items of a Mean, or of any score with missingAs; 0 if all are
  /// needed.
  std::size_t leastAnswered = 0;
  double offset = 0.0;          ///< added to the aggregate
  double factor = 1.0;          ///< multiplies (aggregate + offset)
  double countFrom = 0.0;       ///< Count: the lowest answer that is counted
  std::vector<double> weights;  ///< Mean, Sum: one for each item, from 0 up; or none
  /// Mean, Sum: ids of pairwise choices whose options have the ids of the items. The weight of an
  /// item is how often it was chosen.
  std::vector<std::string> weightsFrom;
  /// The value (before reversal) that replaces a missing answer, provided that at least
  /// leastAnswered items were answered; std::nullopt for no replacement.
  std::optional<double> missingAs;
};

/// The rule by which one person's answers are suspicious because they contradict each other.
struct ConsistencyRule {
  std::vector<std::string> scores;  ///< ids of the scores that are checked
  /// A wider range of keyed answers to the items of a score is a contradiction.
  double widestRange = 0.0;
  /// Smallest number of contradictory scores that makes the answers suspicious.
  std::size_t suspiciousFrom = 1;
};

/// The number of times that an instrument is answered for one result.
enum class Occasions {
  Once,
  BeforeAndAfter,  ///< twice; the result is the change
};

/// The source and licence of an instrument.
struct Source {
  std::string citation;
  std::string doi;
  std::string licence;
  /// Further notes for researchers, for instance who worded it, or what was changed.
  std::string note;
  std::string wordingFrom;  ///< where researchers can obtain the withheld texts
};

/// A questionnaire as its author published it: items, scales, keys and scoring, in several
/// languages. An instrument without items is an information text.
struct Instrument {
  std::string id;
  std::string version;
  LocalizedText title;  ///< participants may see it
  /// Shown above the items; the text of an information or consent form.
  LocalizedText introduction;
  Source source;
  std::vector<std::string> languages;
  std::optional<Scale> scale;  ///< of items without a scale of their own
  std::vector<Item> items;
  std::vector<Score> scores;
  Occasions occasions = Occasions::Once;
  std::optional<ConsistencyRule> consistency;

  const Item* item(std::string_view id) const noexcept;
  /// The items of @p set in order; all items if @p set is empty.
  std::vector<Item> itemsOf(std::string_view set) const;
  const Score* score(std::string_view id) const noexcept;
  /// Whether some of its texts come from a wording file (questionnaires/reading/wording.h).
  bool isWithheld() const noexcept;
};

/// The problems of @p instrument as a whole: duplicate ids, scores of items that do not exist,
/// texts that lack a language. Warns of statements that compare with the previous alternative, and
/// of placeholders "[[…]]" that are not filled in. Does not check what the reader checks (types and
/// spelling of keys), or whether withheld texts are supplied (see wording.h).
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
