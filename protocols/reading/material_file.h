#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "haptics/reaming/material/material.h"
#include "haptics/reaming/material/material_fit.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// A material as `palpate material fit` writes it (docs/protocol-format.md, "Material files"), and
/// everything that is wrong with it; nothing where there are errors.
std::optional<haptics::reaming::Material> readMaterial(
    std::string_view json, questionnaires::Problems& problems);

/// Where a fitted series came from.
struct MaterialSource {
  std::string file;    ///< its name without its folder
  std::string sha256;  ///< of its bytes, in hexadecimal; empty where it is synthetic
};

/// A fit as JSON text, every number so that it reads back exactly, with what was measured, left out
/// and chosen. @param sources  of each series, in the order of the fit.
std::string materialAsJson(
    const std::string& name,
    const std::string& title,
    bool isSynthetic,
    const haptics::reaming::MaterialFit& fit,
    const haptics::reaming::FitOptions& options,
    const std::vector<MaterialSource>& sources);

/// The names of the choices in a fit, as files and commands use them.
std::string_view nameOf(haptics::reaming::NodeRule rule) noexcept;
std::string_view nameOf(haptics::reaming::SplineKind kind) noexcept;
std::string_view nameOf(haptics::reaming::EnvelopeRule rule) noexcept;
std::string_view nameOf(haptics::reaming::DepthAxis axis) noexcept;
std::string_view nameOf(haptics::reaming::CutoffRule rule) noexcept;

}  // namespace protocols
