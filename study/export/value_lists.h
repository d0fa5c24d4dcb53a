#pragma once

#include "study/export/column.h"
#include "study/export/export.h"

namespace study {

/// The values of columns with closed lists, in their natural order, for dictionaries and ordered
/// factors. Cohorts, blocks and conditions are those of all versions of the protocol, the newest
/// first; sites are those of the exported sessions, if there are several. Blinded exports have no
/// list of conditions, and their codes have no labels.
ValueLists valueListsOf(Study& study, const ExportOptions& options);

/// The values of item_type in words: "likert, slider or number".
std::string itemTypesInWords();

}  // namespace study
