#include <cstdint>
#include <string>
#include <vector>

#include "protocols/reading/cut_file.h"

namespace protocols {
namespace {

using haptics::recordings::RowRange;
using questionnaires::Node;
using questionnaires::Value;

/// The whole number in @p value; 0 if @p value is no whole number of at least 1.
std::size_t countOf(const Value& value) {
  const auto* whole = std::get_if<std::int64_t>(&value.data);
  return whole == nullptr || *whole < 1 ? 0 : static_cast<std::size_t>(*whole);
}

std::vector<RowRange> readRows(const std::vector<Node>& entries) {
  std::vector<RowRange> rows;
  for (const auto& entry : entries) {
    const auto* ends = std::get_if<Value::Array>(&entry.value().data);
    const bool isPair = ends != nullptr && ends->size() == 2;
    const RowRange range = isPair ? RowRange{countOf((*ends)[0]), countOf((*ends)[1])} : RowRange{};
    if (range.first == 0 || range.last < range.first) {
      entry.problem(
          "", "a first and a last row are expected here", "write [first, last], counted from 1");
    }
    rows.push_back(range);
  }
  return rows;
}

std::vector<std::size_t> readClosures(const std::vector<Node>& entries) {
  std::vector<std::size_t> closures;
  for (const auto& entry : entries) {
    closures.push_back(countOf(entry.value()));
    if (closures.back() > 0) continue;
    entry.problem(
        "", "the number of a closure is expected here", "write a whole number, counted from 1");
  }
  return closures;
}

void checkHash(const Node& node) {
  constexpr std::size_t kHashDigits = 64;
  const std::string hash = node.text("source_sha256", "");
  const bool isHash =
      hash.size() == kHashDigits && hash.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (hash.empty() || isHash) return;
  node.problem("source_sha256", "this is no SHA-256", "write 64 of the digits 0-9 and a-f");
}

}  // namespace

haptics::recordings::Provenance readProvenance(const Node& cut) {
  constexpr double kMostSlope = 1e9;  // [N/travel unit]
  haptics::recordings::Provenance provenance;
  const auto node = cut.object("provenance");
  if (!node || !node->isObjectWithOnlyKeys(
                   {"statement",
                    "source_file",
                    "source_sha256",
                    "rows",
                    "closures",
                    "calibration",
                    "filter",
                    "filter_parameters",
                    "slope_limit_n_per_travel_unit",
                    "changes"})) {
    return provenance;
  }
  provenance.statement = node->text("statement", "");
  provenance.sourceFile = node->text("source_file", "");
  checkHash(*node);
  provenance.calibration = node->text("calibration", "");
  provenance.filter = node->text("filter", "");
  provenance.filterParameters = node->text("filter_parameters", "");
  if (node->has("slope_limit_n_per_travel_unit")) {
    provenance.slopeLimit = node->number("slope_limit_n_per_travel_unit", 0.0, kMostSlope);
  }
  provenance.changes = node->texts("changes");
  const auto rows = node->list("rows");
  const auto closures = node->list("closures");
  provenance.rows = readRows(rows);
  provenance.closures = readClosures(closures);
  return provenance;
}

}  // namespace protocols
