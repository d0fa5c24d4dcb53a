#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>

/// Parses what the published Arduino sketch of the punch prints: text, one line per loop, without
/// header, sequence number or checksum. With it Palpate can show recordings of that sketch, and
/// punches that still run it.
namespace haptics::wire {

/// The line "y0,y1,…,yN-1": displacements of the midpoints of the sketch's string [travel units].
struct SketchMesh {
  static constexpr std::size_t kMost = 64;  ///< the sketch has 5, its visualiser expects 10
  static constexpr double kStart = 0.5;     ///< left end of the string [string units]
  static constexpr double kEnd = 2.0;
  static constexpr double kTool = 1.5;

  std::array<double, kMost> displacements{};
  std::size_t count = 0;  ///< 2 to kMost

  /// Displacement at the tool as the published visualiser shows it [travel units]: that of the
  /// element [xᵢ, xᵢ₊₁), xᵢ = 0.5 + 1.5 i/N, that contains x = 1.5, without interpolation.
  double toolDisplacement() const noexcept;
};

/// The line "FEM⇥empirical⇥average⇥": the forces of a loop [N].
struct SketchForces {
  double finiteElements = 0.0;
  double interpolation = 0.0;
  double average = 0.0;
};

using SketchLine = std::variant<SketchMesh, SketchForces>;

/// Parses one line, with or without its CR LF. std::nullopt if it is neither kind of line: other
/// text, truncated, an empty field, more than kMost fields, an invalid number. Independent of the
/// locale.
std::optional<SketchLine> parseSketchLine(std::string_view line) noexcept;

}  // namespace haptics::wire
