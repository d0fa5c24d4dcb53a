#pragma once

#include <array>
#include <string>

#include "base/message.h"
#include "study/results/results.h"
#include "study/words/words.h"

namespace study::report {

/// Why a report leaves out a number that is defined.
inline constexpr auto kSmallSampleMessages =
    std::to_array<base::MessageKind>({{"fewer_people", "it needs at least {} participants"}});

/// Removes what a report does not show of few people. Exports and `stats run` keep these numbers.
/// - Tests and reliabilities of fewer than StatisticalTest::fewestPeople; a reason of
///   kSmallSampleMessages is left in their place.
/// - Where a cohort has one participant: scores from which, with the scores before them and the
///   means that families compare, an answer to a single item could be worked out, such as a score
///   of all compared items but one; shares of acceptable answers to an item.
void leaveOutSmallSamples(
    Results& results, const std::vector<questionnaires::Instrument>& instruments);

/// The sentence that says which tests of a family were left out, and why; empty if none was.
std::string leftOutInWords(const FamilyResult& family, const words::Words& words);

}  // namespace study::report
