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

/// Reads a cut as `palpate recording import` writes it (docs/protocol-format.md, "Cut files") and
/// reports all problems; std::nullopt if there are errors.
std::optional<haptics::recordings::Cut> readCut(
    std::string_view json, questionnaires::Problems& problems);

/// A cut as JSON text; numbers can be read back exactly.
/// @param sha256  hash of the recording's bytes in hexadecimal; empty if there is no recording.
std::string cutAsJson(const haptics::recordings::Cut& cut, std::string_view sha256);

/// A curve as nodes for the force engine.
std::vector<haptics::models::CurveNode<double>> nodesOf(
    const haptics::recordings::ForceCurve& curve);

/// Reads the origin of a cut from a whole cut file (docs/protocol-format.md, "Cut files").
haptics::recordings::Provenance readProvenance(const questionnaires::Node& cut);

}  // namespace protocols
