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

/// Removes what a report does not show of few people (StatisticalTest::fewestPeople); a reason of
/// kSmallSampleMessages is left in its place. Exports and `stats run` keep these numbers.
void leaveOutSmallSamples(Results& results);

/// The sentence that says which tests of a family were left out, and why; empty if none was.
std::string leftOutInWords(const FamilyResult& family, const words::Words& words);

}  // namespace study::report
