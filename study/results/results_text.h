#pragma once

#include <string>

#include "study/results/apa_text.h"
#include "study/results/results.h"

namespace study {

/// The tables of a study for a terminal: means and preferences in the form of the punch paper's
/// Tables 2 and 4, the comparisons of @p profile, and notes on them.
std::string resultsAsText(
    Study& study, const Results& results, Profile profile, Wording wording = Wording::Apa);

}  // namespace study
