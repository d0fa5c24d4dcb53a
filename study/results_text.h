#pragma once

#include <string>

#include "study/results.h"

namespace study {

/// The tables of a study in the shape of the punch paper's Tables 2, 3 and 4, for a terminal.
std::string resultsAsText(Study& study, const Results& results);

/// A number with so many decimals, halves to the even digit; "–" where there is none. One function
/// for every table and figure, so that they agree.
std::string rounded(const std::optional<double>& value, int digits);

/// A p value as it stands in a text: ".021", "< .001"; "–" where there is none.
std::string pInWords(const std::optional<double>& p);

}  // namespace study
