#pragma once

#include "study/export/column.h"
#include "study/export/export.h"

namespace study {

/// The values of columns with closed lists, in their natural order: for dictionaries and ordered
/// factors. Cohorts, blocks and conditions are those of all versions of the protocol, the newest
/// first; sites those of the exported sessions, if there are several. In blinded exports conditions
/// are left out, and their codes have no labels.
ValueLists valueListsOf(Study& study, const ExportOptions& options);

/// "likert, slider or number": the values of item_type, in every table.
std::string itemTypesInWords();

}  // namespace study
