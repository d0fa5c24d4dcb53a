#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/reaming/material/material.h"
#include "haptics/reaming/material/material_fit.h"
#include "haptics/reaming/material/series.h"
#include "questionnaires/json/document.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// The values of the key "test_set" in files of materials and scenes.
inline constexpr std::array kTestSetChoices = [] {
  using haptics::reaming::TestSet;
  const auto choice = [](TestSet set) { return questionnaires::Choice<TestSet>{nameOf(set), set}; };
  return std::array{choice(TestSet::Static), choice(TestSet::Dynamic1), choice(TestSet::Dynamic2)};
}();

/// Reads a material as `palpate material fit` writes it (docs/protocol-format.md, "Material files")
/// and reports all problems; std::nullopt if there are errors.
std::optional<haptics::reaming::Material> readMaterial(
    std::string_view json, questionnaires::Problems& problems);

/// The file that a measurement series was read from.
struct MaterialSource {
  std::string file;    ///< file name without folder
  std::string sha256;  ///< hash of its bytes in hexadecimal; empty if the series is synthetic
};

/// A fit as JSON text, with the facts on measurement and fit; numbers can be read back exactly.
/// @param sources  file of each series, in the order of the fit.
std::string materialAsJson(
    const std::string& name,
    const std::string& title,
    bool isSynthetic,
    const haptics::reaming::MaterialFit& fit,
    const haptics::reaming::FitOptions& options,
    const std::vector<MaterialSource>& sources);

/// Names of the options of a fit in files and commands.
std::string_view nameOf(haptics::reaming::NodeRule rule) noexcept;
std::string_view nameOf(haptics::reaming::SplineKind kind) noexcept;
std::string_view nameOf(haptics::reaming::EnvelopeRule rule) noexcept;
std::string_view nameOf(haptics::reaming::DepthAxis axis) noexcept;
std::string_view nameOf(haptics::filters::CutoffRule rule) noexcept;

}  // namespace protocols
