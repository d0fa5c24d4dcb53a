#pragma once

#include "study/export/column.h"
#include "study/export/export.h"

namespace study {

/// What may stand in columns with closed lists, in the natural order: for dictionaries, and for
/// ordered factors. Cohorts, blocks and conditions are those of all versions of the protocol, the
/// newest first. Blinded, conditions are not among them, and their codes stand for themselves.
ValueLists valueListsOf(Study& study, const ExportOptions& options);

}  // namespace study
