#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/storage/records.h"

namespace study {

/// The answers of one cohort to one item about one condition. Numeric answers are counted by
/// participant, with the mean of a participant's answers; options are counted by answered form.
struct ItemSummary {
  std::string instrument;
  std::string item;
  std::string cohort;
  std::string condition;    ///< empty if the item is not about a condition
  std::size_t answers = 0;  ///< number of forms with an answer to the item

  std::vector<double> values;  ///< points or numbers, not reversed: one mean per participant
  std::optional<double> mean;
  std::optional<double> standardDeviation;  ///< of a sample: divided by n − 1
  std::optional<double> median;
  std::optional<double> least;
  std::optional<double> most;

  /// How often each option was chosen: option id and count, in the item's order; empty for other
  /// items.
  std::vector<std::pair<std::string, std::uint64_t>> options;
};

/// A free text of a participant, or of the operator about one.
struct Quote {
  std::string instrument;
  std::string item;
  std::string condition;  ///< the condition it is about; for a preference the chosen one; empty if
                          ///< none
  std::string text;
  bool isNote = false;  ///< whether the operator wrote it, in an interview

  bool operator==(const Quote&) const = default;
};

/// The result of summariseItems().
struct ItemResults {
  std::vector<ItemSummary> items;  ///< by instrument, item, cohort and condition
  std::vector<Quote> quotes;       ///< by instrument, item and condition
};

/// Describes every answered item of questionnaires, forms, preferences and interviews. Leaves out
/// consent forms, items that name a person, choices among alternatives (see VoteResult), and free
/// texts of forms before the first block, because texts about the participant may identify them.
/// @param sessions  the sessions that are evaluated
/// @param answers  all answers of these sessions
ItemResults summariseItems(
    const protocols::LoadedProtocol& loaded,
    const std::map<SessionId, storage::SessionRecord>& sessions,
    const std::vector<storage::AnswerRecord>& answers,
    const storage::Records::Allocation& allocation);

}  // namespace study
