#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>

/// What the published punch sketch prints: text, one line a loop, without header, number or
/// checksum. Read so that a recording of it, or a punch that still runs it, can be looked at.
namespace haptics::wire {

/// Displacements of the midpoints of the sketch's string [travel units]: "y0,y1,…,yN-1".
struct SketchMesh {
  static constexpr std::size_t kMost = 64;  ///< the sketch has 5, its visualiser wants 10
  static constexpr double kStart = 0.5;     ///< of the string [string units]
  static constexpr double kEnd = 2.0;
  static constexpr double kTool = 1.5;

  std::array<double, kMost> displacements{};
  std::size_t count = 0;  ///< 2 to kMost

  /// Where the tool is, as the visualiser takes it: the displacement of the element that x = 1.5
  /// is in, of elements [xᵢ, xᵢ₊₁) with xᵢ = 0.5 + 1.5 i/N. Nothing is interpolated.
  double toolDisplacement() const noexcept;
};

/// The forces of a loop [N]: "FEM⇥empirical⇥average⇥".
struct SketchForces {
  double finiteElements = 0.0;
  double interpolation = 0.0;
  double average = 0.0;
};

using SketchLine = std::variant<SketchMesh, SketchForces>;

/// Reads one line, with or without its CR LF. std::nullopt if it is not such a line: other words,
/// truncated, an empty field, more than kMost, an invalid number. Independent of the locale.
std::optional<SketchLine> parseSketchLine(std::string_view line) noexcept;

}  // namespace haptics::wire
