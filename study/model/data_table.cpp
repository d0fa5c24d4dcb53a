#include "study/model/data_table.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace study {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

bool beginsLikeAFormula(const std::string& text) {
  return !text.empty() && std::string("=+-@\t\r").find(text.front()) != std::string::npos;
}

struct TextOfCell {
  std::string operator()(std::monostate) const { return "–"; }
  std::string operator()(bool value) const { return value ? "yes" : "no"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return fmt::format("{:.4g}", value); }
  std::string operator()(const std::string& value) const { return value; }
};

}  // namespace

Cell finiteCell(double value) {
  return std::isfinite(value) ? Cell(value) : Cell();
}

std::string textOfCell(const Cell& cell) {
  return std::visit(TextOfCell(), cell);
}

std::string withFormulaEscaped(const std::string& text) {
  return beginsLikeAFormula(text) ? "'" + text : text;
}

std::string csvCell(const Cell& cell, bool isFreeText) {
  if (const auto* flag = std::get_if<bool>(&cell)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&cell)) return exactDecimal(*number);
  if (const auto* text = std::get_if<std::string>(&cell)) {
    return quoted(isFreeText ? withFormulaEscaped(*text) : *text);
  }
  return {};
}

std::string exactDecimal(double value) {
  std::array<char, 40> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

}  // namespace study
