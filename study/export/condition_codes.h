#pragma once

#include <map>
#include <string>

#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace study {

/// The codes of conditions in exports: "C2". A condition that a later version of the protocol adds
/// gets a new code; codes never change.
///
/// Each blinded export of live or pilot sessions has codes of its own (docs/decisions/0050): who
/// has two of them, or knows one, cannot tell what the codes of the other mean. They follow from
/// the study's key and the export's @p set. Simulated sessions, and all sessions of studies that
/// release 0.1 made, have the codes of the seed.
/// @param set  32 hexadecimal digits; empty: codes of the study itself, which no blinded export has
/// @throws storage::StorageError  if the key is needed and not here
std::map<std::string, std::string> conditionCodes(
    Study& study, RunMode mode, const std::string& set = {});

/// Whether the codes of that run mode are drawn for each export.
bool drawsCodesForEachExport(Study& study, RunMode mode);

/// 128 random bits, the name of a new set of codes.
std::string drawnCodeSet();

/// The set of codes that an export used, from its codebook or its document.
/// @throws UserError  if the folder is no export, or has the codes of the seed.
std::string codeSetOf(const std::string& folder);

}  // namespace study
