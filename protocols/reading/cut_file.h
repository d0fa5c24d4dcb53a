#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/models/interpolation.h"
#include "haptics/recordings/cut.h"
#include "questionnaires/json/document.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// A cut as `palpate recording import` writes it (docs/protocol-format.md, "Cut files"), and
/// everything that is wrong with it; nothing where there are errors.
std::optional<haptics::recordings::Cut> readCut(
    std::string_view json, questionnaires::Problems& problems);

/// The same as JSON text, every number so that it reads back exactly. @p sha256 is of the
/// recording's bytes, in hexadecimal; empty where there was none.
std::string cutAsJson(const haptics::recordings::Cut& cut, std::string_view sha256);

/// A curve as the force engine wants it.
std::vector<haptics::models::CurveNode<double>> nodesOf(
    const haptics::recordings::ForceCurve& curve);

/// Reads from a whole cut file where the cut comes from (docs/protocol-format.md, "Cut files");
/// everything that is wrong with it goes into @p problems.
haptics::recordings::Provenance readProvenance(
    const questionnaires::Value& cut, questionnaires::Problems& problems);

}  // namespace protocols
