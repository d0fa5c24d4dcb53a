#include "analysis/published/published_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "analysis/data/csv_table.h"
#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

std::int64_t powerOfTen(int exponent) {
  std::int64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

bool isDigit(char character) {
  return character >= '0' && character <= '9';
}

bool isDecimalMark(char character, base::DecimalMark mark) {
  return character == '.' || (character == ',' && mark == base::DecimalMark::PointOrComma);
}

}  // namespace

double ReportedNumber::value() const {
  return static_cast<double>(digits) / static_cast<double>(powerOfTen(decimals));
}

std::string ReportedNumber::text() const {
  std::string figures = std::to_string(std::abs(digits));
  const auto places = static_cast<std::size_t>(decimals);
  if (figures.size() <= places) figures.insert(0, places + 1 - figures.size(), '0');
  if (places > 0) figures.insert(figures.size() - places, ".");
  return (digits < 0 ? "-" : "") + figures;
}

Interval ReportedNumber::bounds(RoundingRule rounding) const {
  const auto unit = static_cast<double>(powerOfTen(decimals));
  const auto number = static_cast<double>(digits);
  if (rounding == RoundingRule::Rounded) {
    return {.low = (number - 0.5) / unit, .high = (number + 0.5) / unit};
  }
  return {
      .low = digits > 0 ? number / unit : (number - 1.0) / unit,
      .high = digits < 0 ? number / unit : (number + 1.0) / unit};
}

bool ReportedNumber::matchesQuotient(
    std::int64_t numerator, std::int64_t denominator, RoundingRule rounding) const {
  // Multiplies both sides by denominator · 10^decimals, and compares whole numbers without
  // rounding.
  const Int128 given = Int128(powerOfTen(decimals)) * numerator;
  const Int128 printed = Int128(digits) * denominator;
  if (rounding == RoundingRule::Rounded) {
    const Int128 gap = 2 * (given - printed);
    return -Int128(denominator) <= gap && gap <= Int128(denominator);
  }
  const Int128 gap = digits < 0 || (digits == 0 && given < 0) ? printed - given : given - printed;
  return gap >= 0 && gap < denominator;
}

bool ReportedNumber::matchesRootOf(
    std::int64_t numerator, std::int64_t denominator, RoundingRule rounding) const {
  if (digits < 0) return false;
  const Int128 given = Int128(powerOfTen(2 * decimals)) * numerator;
  if (rounding == RoundingRule::Rounded) {
    const Int128 low = std::max<std::int64_t>(2 * digits - 1, 0);
    const Int128 high = 2 * digits + 1;
    return low * low * denominator <= 4 * given && 4 * given <= high * high * denominator;
  }
  const Int128 low = digits;
  const Int128 high = digits + 1;
  return low * low * denominator <= given && given < high * high * denominator;
}

std::optional<ReportedNumber> reportedNumber(std::string_view text, base::DecimalMark mark) {
  const bool isNegative = text.starts_with('-');
  if (isNegative || text.starts_with('+')) text.remove_prefix(1);

  ReportedNumber number;
  int figures = 0;
  bool hasMark = false;
  for (const char character : text) {
    if (isDecimalMark(character, mark) && !hasMark) {
      hasMark = true;
    } else if (isDigit(character) && figures < ReportedNumber::kMostDigits) {
      number.digits = 10 * number.digits + (character - '0');
      number.decimals += hasMark ? 1 : 0;
      ++figures;
    } else {
      return std::nullopt;
    }
  }
  if (figures == 0) return std::nullopt;
  if (isNegative) number.digits = -number.digits;
  return number;
}

namespace {

base::DecimalMark decimalMarkOf(const CsvTable& table) {
  return table.separator == ',' ? base::DecimalMark::Point : base::DecimalMark::PointOrComma;
}

bool hasColumn(const CsvTable& table, std::string_view name) {
  return std::ranges::find(table.columns, name) != table.columns.end();
}

std::string quoted(const std::string& text) {
  return "'" + text + "'";
}

/// Reads the cells of a row and collects their problems.
class RowReader {
 public:
  RowReader(const CsvTable& table, std::string_view file, std::vector<std::string>& problems)
      : table_(table), file_(file), problems_(problems) {}

  void begin(const CsvRow& row) { row_ = &row; }
  const std::string& cell(std::string_view column) const {
    return row_->cells[table_.columnIndex(column)];
  }

  void addProblem(const std::string& what) {
    problems_.push_back(file_ + ", line " + std::to_string(row_->line) + ": " + what);
  }

  ReportedNumber number(std::string_view column) {
    const auto number = reportedNumber(cell(column), decimalMarkOf(table_));
    if (!number) {
      addProblem(
          quoted(cell(column)) + " is no " + std::string(column) +
          ": write it as it is printed, "
          "for instance 4.10, with at most nine digits");
    }
    return number.value_or(ReportedNumber{});
  }

 private:
  const CsvTable& table_;
  std::string file_;
  std::vector<std::string>& problems_;
  const CsvRow* row_ = nullptr;
};

std::optional<std::uint64_t> sizeOf(RowReader& reader) {
  const auto& cell = reader.cell("n");
  if (cell.empty() || cell == "NA") return std::nullopt;
  const auto n = reportedNumber(cell);
  const bool isSize = n && n->decimals == 0 && n->digits >= 2 &&
                      n->digits <= static_cast<std::int64_t>(kLargestPublishedGroup);
  if (isSize) return static_cast<std::uint64_t>(n->digits);
  reader.addProblem(
      quoted(cell) + " is no size of a group: a whole number from 2 to " +
      std::to_string(kLargestPublishedGroup) + ", or nothing where it is not known");
  return std::nullopt;
}

void readGroups(const CsvTable& csv, PublishedTable& table, std::vector<std::string>& problems) {
  const bool isStandardDeviation = !hasColumn(csv, "variance") && hasColumn(csv, "sd");
  const std::string_view spread = isStandardDeviation ? "sd" : "variance";
  for (const auto* column : {"group", "mean"}) csv.columnIndex(column);
  csv.columnIndex(spread);
  RowReader reader(csv, "groups", problems);
  std::set<std::string> seen;
  for (const auto& row : csv.rows) {
    reader.begin(row);
    PublishedGroup group{.name = reader.cell("group")};
    if (group.name.empty()) reader.addProblem("the group has no name");
    if (!seen.insert(group.name).second) {
      reader.addProblem("a second group is called " + quoted(group.name));
    }
    if (hasColumn(csv, "n")) group.n = sizeOf(reader);
    group.mean = reader.number("mean");
    group.spread = reader.number(spread);
    group.isStandardDeviation = isStandardDeviation;
    if (group.spread.digits < 0)
      reader.addProblem("a " + std::string(spread) + " is never negative");
    table.groups.push_back(group);
  }
}

std::optional<PublishedP> pOf(std::string_view text, base::DecimalMark mark) {
  PublishedP p;
  if (text.starts_with('<')) p.relation = PublishedP::Relation::Below;
  if (text.starts_with('>')) p.relation = PublishedP::Relation::Above;
  if (text.find_first_of("<>=") == 0) text.remove_prefix(1);
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const auto number = reportedNumber(text, mark);
  if (!number || number->digits < 0 || number->value() > 1.0) return std::nullopt;
  p.number = *number;
  return p;
}

std::size_t groupIndex(const std::string& name, const PublishedTable& table, RowReader& reader) {
  const auto found = std::ranges::find(table.groups, name, &PublishedGroup::name);
  if (found == table.groups.end()) {
    std::vector<std::string> names;
    for (const auto& group : table.groups) names.push_back(group.name);
    reader.addProblem(
        "there is no group " + quoted(name) + "; the groups are " + enumerated(names));
    return 0;
  }
  return static_cast<std::size_t>(found - table.groups.begin());
}

void readComparisons(
    const CsvTable& csv, PublishedTable& table, std::vector<std::string>& problems) {
  for (const auto* column : {"group1", "group2", "p"}) csv.columnIndex(column);
  RowReader reader(csv, "comparisons", problems);
  for (const auto& row : csv.rows) {
    reader.begin(row);
    PublishedComparison comparison;
    comparison.first = groupIndex(reader.cell("group1"), table, reader);
    comparison.second = groupIndex(reader.cell("group2"), table, reader);
    if (reader.cell("group1") == reader.cell("group2")) {
      reader.addProblem("a group is not compared with itself");
    }
    const auto p = pOf(reader.cell("p"), decimalMarkOf(csv));
    if (!p) reader.addProblem(quoted(reader.cell("p")) + " is no p: write .021, < .001 or > .05");
    comparison.p = p.value_or(PublishedP{});
    table.comparisons.push_back(comparison);
  }
}

void checkCounts(const PublishedTable& table, std::vector<std::string>& problems) {
  if (table.groups.size() < 2 || table.groups.size() > kMostPublishedGroups) {
    problems.push_back(
        "a table has 2 to " + std::to_string(kMostPublishedGroups) + " groups; here are " +
        std::to_string(table.groups.size()));
  }
  if (table.comparisons.empty() || table.comparisons.size() > kMostPublishedComparisons) {
    problems.push_back(
        "a table has 1 to " + std::to_string(kMostPublishedComparisons) +
        " comparisons; here are " + std::to_string(table.comparisons.size()));
  }
}

}  // namespace

std::string PublishedP::text() const {
  std::string digits = number.text();
  if (digits.starts_with("0.")) digits.erase(0, 1);
  if (relation == Relation::Equal) return digits;
  return (relation == Relation::Below ? "< " : "> ") + digits;
}

Interval PublishedP::bounds(RoundingRule rounding) const {
  if (relation == Relation::Below) return {.low = 0.0, .high = number.value()};
  if (relation == Relation::Above) return {.low = number.value(), .high = 1.0};
  const Interval printed = number.bounds(rounding);
  return {.low = std::max(printed.low, 0.0), .high = std::min(printed.high, 1.0)};
}

PublishedTable readPublishedTable(std::string_view groupsCsv, std::string_view comparisonsCsv) {
  PublishedTable table;
  std::vector<std::string> problems;
  readGroups(readCsv(groupsCsv), table, problems);
  readComparisons(readCsv(comparisonsCsv), table, problems);
  checkCounts(table, problems);
  if (!problems.empty()) throw errorOf(problems);
  return table;
}

}  // namespace analysis
