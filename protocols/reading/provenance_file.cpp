#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "protocols/reading/cut_file.h"

namespace protocols {
namespace {

using haptics::recordings::RowRange;
using questionnaires::Node;
using questionnaires::Problems;
using questionnaires::Value;

const std::string kPath = "$.provenance";

/// The member of a JSON object in a list; a Node reads by key only.
const Value* memberOf(const Value& object, std::string_view key) {
  const auto& members = std::get<Value::Object>(object.data);
  const auto member =
      std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.key == key; });
  return member == members.end() ? nullptr : &member->value;
}

Value::Array entriesOf(const Value& object, std::string_view key) {
  const Value* list = memberOf(object, key);
  const auto* entries = list == nullptr ? nullptr : std::get_if<Value::Array>(&list->data);
  return entries == nullptr ? Value::Array() : *entries;
}

/// A number that counts from 1; 0 if it is invalid.
std::size_t countOf(const Value& value) {
  const auto* whole = std::get_if<std::int64_t>(&value.data);
  return whole == nullptr || *whole < 1 ? 0 : static_cast<std::size_t>(*whole);
}

std::vector<RowRange> readRows(const Value& provenance, Problems& problems) {
  std::vector<RowRange> rows;
  for (const auto& entry : entriesOf(provenance, "rows")) {
    const auto* ends = std::get_if<Value::Array>(&entry.data);
    const bool isPair = ends != nullptr && ends->size() == 2;
    const RowRange range = isPair ? RowRange{countOf((*ends)[0]), countOf((*ends)[1])} : RowRange{};
    if (range.first == 0 || range.last < range.first) {
      problems.add(
          kPath + ".rows[" + std::to_string(rows.size()) + "]",
          "a first and a last row are expected here",
          "write [first, last], counted from 1");
    }
    rows.push_back(range);
  }
  return rows;
}

std::vector<std::size_t> readClosures(const Value& provenance, Problems& problems) {
  std::vector<std::size_t> closures;
  for (const auto& entry : entriesOf(provenance, "closures")) {
    if (countOf(entry) == 0) {
      problems.add(
          kPath + ".closures[" + std::to_string(closures.size()) + "]",
          "the number of a closure is expected here",
          "write a whole number, counted from 1");
    }
    closures.push_back(countOf(entry));
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

haptics::recordings::Provenance readProvenance(const Value& cut, Problems& problems) {
  constexpr double kMostSlope = 1e9;  // [N/travel unit]
  haptics::recordings::Provenance provenance;
  const Node root(cut, "$", problems);
  const auto node = root.object("provenance");
  if (!node || !node->isObjectWith(
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
  node->list("rows");  // reports a problem if it is not a list
  node->list("closures");
  provenance.rows = readRows(*memberOf(cut, "provenance"), problems);
  provenance.closures = readClosures(*memberOf(cut, "provenance"), problems);
  return provenance;
}

}  // namespace protocols
