#pragma once

#include <map>
#include <string>

#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace study {

/// The codes of conditions in exports ("C2"), by condition id. A condition that a later version of
/// the protocol adds gets a new code; existing codes do not change.
///
/// Each blinded export of live or pilot sessions has its own codes (docs/decisions/0050), so that
/// two exports cannot be matched, and a disclosed code reveals nothing about other exports. These
/// codes are computed from the study's key and @p set. The codes of simulated sessions, and of all
/// sessions of studies that release 0.1 created, are computed from the seed.
/// @param set  name of the set of codes, 32 hexadecimal digits; empty: the set that is never used
///     in blinded exports
/// @throws storage::StorageError  if the key is needed but not available
std::map<std::string, std::string> conditionCodes(
    Study& study, RunMode mode, const std::string& set = {});

/// Whether each export of that run mode gets its own set of codes.
bool drawsCodesForEachExport(Study& study, RunMode mode);

/// A random name of a new set of codes: 128 bits in hexadecimal.
std::string drawnCodeSet();

/// The name of the set of codes of an existing export, from its codebook or JSON document.
/// @throws UserError  if the folder is no export, or if its codes are computed from the seed.
std::string codeSetOf(const std::string& folder);

}  // namespace study
