#include "haptics/wire/sketch_line.h"

#include <charconv>
#include <cmath>
#include <span>
#include <system_error>

namespace haptics::wire {
namespace {

/// Parses a number as the sketch prints it: digits, a point, an optional sign; no exponent, "nan"
/// or spaces.
std::optional<double> numberFrom(std::string_view text) noexcept {
  constexpr std::size_t kLongest = 24;
  if (text.empty() || text.size() > kLongest) return std::nullopt;
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Parses numbers separated by @p separator; returns how many, or std::nullopt if one is invalid or
/// there are more than fit into @p into.
std::optional<std::size_t> readFields(
    std::string_view line, char separator, std::span<double> into) noexcept {
  std::size_t count = 0;
  for (;;) {
    const std::size_t end = line.find(separator);
    const auto value = numberFrom(line.substr(0, end));
    if (!value || count == into.size()) return std::nullopt;
    into[count++] = *value;
    if (end == std::string_view::npos) return count;
    line.remove_prefix(end + 1);
  }
}

std::optional<SketchLine> readMesh(std::string_view line) noexcept {
  SketchMesh mesh;
  const auto count = readFields(line, ',', mesh.displacements);
  if (!count || *count < 2) return std::nullopt;
  mesh.count = *count;
  return mesh;
}

std::optional<SketchLine> readForces(std::string_view line) noexcept {
  if (line.back() != '\t') return std::nullopt;
  line.remove_suffix(1);
  std::array<double, 3> forces{};
  if (readFields(line, '\t', forces) != forces.size()) return std::nullopt;
  return SketchForces{
      .finiteElements = forces[0], .interpolation = forces[1], .average = forces[2]};
}

}  // namespace

double SketchMesh::toolDisplacement() const noexcept {
  if (count == 0 || count > kMost) return 0.0;
  const auto elements = static_cast<double>(count);
  const auto element = static_cast<std::size_t>((kTool - kStart) * elements / (kEnd - kStart));
  return displacements[element];
}

std::optional<SketchLine> parseSketchLine(std::string_view line) noexcept {
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.empty()) return std::nullopt;
  const bool hasTabs = line.find('\t') != std::string_view::npos;
  return hasTabs ? readForces(line) : readMesh(line);
}

}  // namespace haptics::wire
