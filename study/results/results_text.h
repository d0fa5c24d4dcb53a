#pragma once

#include <string>

#include "study/results/apa_text.h"
#include "study/results/results.h"

namespace study {

/// The results of a study as tables for a terminal: means and preferences like Tables 2 and 4 of
/// the punch paper, the comparisons of @p profile, and notes.
std::string resultsAsText(
    Study& study, const Results& results, Profile profile, Wording wording = Wording::Apa);

}  // namespace study
