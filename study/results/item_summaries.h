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

/// The answers of one cohort to one item about one condition. The unit of numbers is the
/// participant, with the mean of their answers; the unit of options is the answered form.
struct ItemSummary {
  std::string instrument;
  std::string item;
  std::string cohort;
  std::string condition;    ///< empty if the item is not about a condition
  std::size_t answers = 0;  ///< forms that answered it

  std::vector<double> values;  ///< points or numbers, not reversed: one mean for each participant
  std::optional<double> mean;
  std::optional<double> standardDeviation;  ///< with n - 1
  std::optional<double> median;
  std::optional<double> least;
  std::optional<double> most;

  /// How often each option was chosen, by id, in the order of the item; empty for other items.
  std::vector<std::pair<std::string, std::uint64_t>> options;
};

/// A free text of a participant.
struct Quote {
  std::string instrument;
  std::string item;
  std::string condition;  ///< the text's condition; for a preference the chosen one; empty: none
  std::string text;

  bool operator==(const Quote&) const = default;
};

struct ItemResults {
  std::vector<ItemSummary> items;  ///< by instrument, item, cohort and condition
  std::vector<Quote> quotes;       ///< by instrument, item and condition
};

/// Describes every answered item of questionnaires, forms, preferences and interviews. Left out are
/// consent forms, items that name a person, choices among alternatives (VoteResult), and texts of
/// forms before the first block: what people write about themselves may tell who they are.
/// @param sessions  whose answers count
/// @param answers  of those sessions
ItemResults summariseItems(
    const protocols::LoadedProtocol& loaded,
    const std::map<SessionId, storage::SessionRecord>& sessions,
    const std::vector<storage::AnswerRecord>& answers,
    const std::map<storage::Records::Alternative, std::string>& allocation);

}  // namespace study
