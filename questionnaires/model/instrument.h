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

/// A text in the languages its author wrote it in, by language tag ("en", "de", "nb").
class LocalizedText {
 public:
  LocalizedText() = default;
  explicit LocalizedText(std::map<std::string, std::string> byLanguage)
      : byLanguage_(std::move(byLanguage)) {}

  /// The text in @p language, or in English if there is none; empty where there is neither.
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
  SemanticDifferential,  ///< between two opposite words, on a scale of points
  Slider,                ///< anywhere between two ends; shows no handle until it is touched
  SingleChoice,          ///< one of several options
  MultipleChoice,        ///< any number of several options, none included
  Number,
  ShortText,       ///< one line
  LongText,        ///< several lines
  PairwiseChoice,  ///< one of two
};

/// What the answer to an item is.
enum class AnswerKind {
  Point,    ///< of its scale
  Number,   ///< between its least and most
  Option,   ///< the id of one of its options
  Options,  ///< the ids of any number of them
  Text,
};

/// A type of items: its name in files and exports, and what is answered.
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

/// Points to choose from, from `lowest` up, one apart.
struct Scale {
  int lowest = 1;
  int points = 5;
  LocalizedText lowLabel;                  ///< what the lowest point means
  LocalizedText highLabel;                 ///< what the highest point means
  std::vector<LocalizedText> pointLabels;  ///< one for each point, or none

  int highest() const noexcept { return lowest + points - 1; }
  bool operator==(const Scale& other) const = default;
};

/// How few and how many points a scale may have.
inline constexpr int kFewestPoints = 2;
inline constexpr int kMostPoints = 101;

/// How much a file may ask.
inline constexpr std::size_t kMostItems = 1000;
inline constexpr std::size_t kMostScores = 1000;
inline constexpr std::size_t kMostOptions = 1000;

/// How long an answer in words may be where its item does not say so [characters].
inline constexpr std::int64_t kLongestShortText = 500;
inline constexpr std::int64_t kLongestLongText = 100'000;

/// One of the things that may be chosen.
struct Option {
  std::string id;
  LocalizedText text;
};

/// Where an item's options come from.
enum class OptionSource {
  Listed,        ///< from the instrument
  Alternatives,  ///< they are the alternatives that the participant has felt in a block
};

/// What a statement compares with.
enum class Reference {
  None,
  Previous,  ///< with what was felt just before ("than the previous cut")
};

/// What in a study a question asks about. Where the study has no such thing the question is left
/// out.
enum class Referent {
  None,
  Benchmark,  ///< cuts with the physical tool, made before
  Vibration,  ///< vibration and chatter of the tool
  Pace,       ///< how fast material is removed
  ForceSize,  ///< how large the forces are, against those of an operation
};

/// The words for what a question is about, in files and messages.
inline constexpr std::array kReferents{
    Choice<Referent>{"benchmark", Referent::Benchmark},
    Choice<Referent>{"vibration", Referent::Vibration},
    Choice<Referent>{"pace", Referent::Pace},
    Choice<Referent>{"force_size", Referent::ForceSize},
};

/// A text of an item that its instrument may leave to a wording file.
enum class WordingField { Text, LowLabel, HighLabel, LeftLabel, RightLabel };

/// Which answer to an earlier item makes a question one that is asked.
struct ShowIf {
  std::string item;               ///< a choice; empty: the question is always asked
  std::vector<std::string> isIn;  ///< ids of its options, any of which will do

  bool isSet() const noexcept { return !item.empty(); }
};

/// One question.
struct Item {
  std::string id;
  ItemType type = ItemType::Likert;
  LocalizedText text;  ///< empty where two opposite words say it all
  std::string set;     ///< of the items that are asked together where a step asks for a set only
  int key = 1;         ///< +1: a high answer is good; -1: a low one is
  bool isRequired = true;
  bool isIdentifying = false;  ///< names a person: kept in identity.db, never exported
  bool startsPage = false;     ///< participants see it at the top of a new page
  ShowIf showIf;
  Reference reference = Reference::None;
  Referent refersTo = Referent::None;

  Scale scale;              ///< Likert, SemanticDifferential
  LocalizedText leftText;   ///< SemanticDifferential, Slider: the low end
  LocalizedText rightText;  ///< SemanticDifferential, Slider: the high end
  double least = 0.0;       ///< Slider, Number
  double most = 100.0;      ///< Slider, Number
  double step = 1.0;        ///< Slider, Number; 0 for any value
  std::string unit;         ///< Number: a symbol that is the same in every language
  OptionSource optionSource = OptionSource::Listed;
  std::vector<Option> options;  ///< SingleChoice, MultipleChoice, PairwiseChoice
  std::string consentOption;  ///< SingleChoice: the option that gives consent, if this asks for it
  std::int64_t longestAnswer = 0;  ///< ShortText, LongText [characters]; 0: what is usual

  /// The lowest answer, turned round where the key is -1, that counts as acceptable; std::nullopt
  /// if the study sets no threshold. Likert, SemanticDifferential, Slider, Number.
  std::optional<double> acceptableFrom;
  /// The texts that may not be shipped: a wording file beside the protocol brings them.
  /// Likert, SemanticDifferential, Slider.
  std::vector<WordingField> withheld;

  bool withholds(WordingField field) const noexcept;
};

/// How items become one number. An unanswered item is missing: never the midpoint, never zero.
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
  bool reverseByKey = true;       ///< an answer x to an item with key -1 counts as low + high - x
  std::size_t leastAnswered = 0;  ///< a mean of fewer is no score; 0: all are needed, as for a sum
  double offset = 0.0;            ///< added to the aggregate …
  double factor = 1.0;            ///< … and then multiplied
  double countFrom = 0.0;         ///< Count
  std::vector<double> weights;    ///< Mean, Sum: one for each item, from 0 up; or none
  /// Mean, Sum: pairwise choices whose options bear the ids of the items. An item weighs as often
  /// as it was chosen.
  std::vector<std::string> weightsFrom;
  /// What an unanswered item counts as, before it is turned round, where the author says so and at
  /// least leastAnswered items were answered.
  std::optional<double> missingAs;
};

/// When one person's answers to several scores contradict each other too much to be trusted.
struct ConsistencyRule {
  std::vector<std::string> scores;  ///< those that are looked at
  double widestRange = 0.0;  ///< a wider range of keyed answers within a score is a contradiction
  std::size_t suspiciousFrom = 1;  ///< so many contradictions make the answers suspicious
};

/// How often an instrument is answered to give one result.
enum class Occasions {
  Once,
  BeforeAndAfter,  ///< what counts is the change
};

/// Where an instrument comes from, and what may be done with it.
struct Source {
  std::string citation;
  std::string doi;
  std::string licence;
  std::string note;  ///< what else a researcher should know: whose the wording is, what was changed
  std::string wordingFrom;  ///< where the texts are to be had that are not ours to ship
};

/// A questionnaire as its author published it: items, scales, keys, scoring, in several languages.
/// One without items is information: a text to be read.
struct Instrument {
  std::string id;
  std::string version;
  LocalizedText title;  ///< participants may see it
  LocalizedText
      introduction;  ///< shown above the items; the text of an information or consent form
  Source source;
  std::vector<std::string> languages;
  std::optional<Scale> scale;  ///< of the items that brought none of their own
  std::vector<Item> items;
  std::vector<Score> scores;
  Occasions occasions = Occasions::Once;
  std::optional<ConsistencyRule> consistency;

  const Item* item(std::string_view id) const noexcept;
  /// The items of @p set in order; all of them where @p set is empty.
  std::vector<Item> itemsOf(std::string_view set) const;
  const Score* score(std::string_view id) const noexcept;
  /// Whether texts of it come from a wording file (questionnaires/reading/wording.h).
  bool isWithheld() const noexcept;
};

/// Everything that is wrong with @p instrument as a whole: ids used twice, scores of items that do
/// not exist, texts that lack a language. Warnings are for what its author should know: statements
/// that compare with the previous, placeholders "[[…]]" still to be filled in. Types and the
/// spelling of keys are the reader's business; whether withheld texts are there is wording.h's.
Problems problemsOf(const Instrument& instrument);

/// From the lowest answer to the highest, both included.
struct Range {
  double low = 0.0;
  double high = 0.0;

  bool operator==(const Range& other) const = default;
};

/// Where the answers to @p item lie; std::nullopt if they are no numbers.
std::optional<Range> rangeOf(const Item& item) noexcept;

}  // namespace questionnaires
