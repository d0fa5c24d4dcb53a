#include "analysis/registry/test_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/data/csv_table.h"

namespace analysis {
namespace {

using Kind = DataColumn::Kind;

constexpr std::array kGroupsData{
    DataColumn{.role = "group", .kind = Kind::Name, .what = "names the group"},
    DataColumn{.role = "value", .what = "numbers"}};
constexpr std::array kPairsData{
    DataColumn{.role = "first", .what = "numbers"},
    DataColumn{.role = "second", .what = "numbers of the same people or cases"}};
constexpr std::array kColumnsData{DataColumn{
    .role = "columns", .kind = Kind::Numbers, .what = "numbers, one column a condition or rater"}};
constexpr std::array kValuesData{DataColumn{.role = "value", .what = "numbers"}};
constexpr std::array kCategoriesData{
    DataColumn{.role = "first", .kind = Kind::Name, .what = "names"},
    DataColumn{.role = "second", .kind = Kind::Name, .what = "names"},
    DataColumn{
        .role = "count", .kind = Kind::Count, .isRequired = false, .what = "cases of a line"}};
constexpr std::array kVotesData{
    DataColumn{.role = "value", .kind = Kind::Name, .what = "what was voted for"},
    DataColumn{
        .role = "count", .kind = Kind::Count, .isRequired = false, .what = "votes of a line"}};
constexpr std::array kClustersData{
    DataColumn{.role = "cluster", .kind = Kind::Name, .what = "names the participant"},
    DataColumn{.role = "group", .kind = Kind::Name, .what = "names the group"},
    DataColumn{.role = "value", .what = "numbers"},
    DataColumn{
        .role = "round", .kind = Kind::Name, .isRequired = false, .what = "names the round"}};

bool isMissing(const std::string& cell) {
  return cell.empty() || cell == "NA";
}

std::string notANumberMessage(std::size_t line, const std::string& cell, char separator) {
  const bool hasComma = cell.find(',') != std::string::npos && separator != ';';
  return "line " + std::to_string(line) + ": '" + cell + "' is no number" +
         (hasComma ? "; write the decimals after a point" : "");
}

void requireTwoGroups(const std::vector<NamedValues>& groups, const std::string& column) {
  if (groups.size() == 2) return;
  std::vector<std::string> names;
  names.reserve(groups.size());
  for (const auto& group : groups) names.push_back(group.name);
  std::string there = "no groups";
  if (names.size() == 1) there = "one group only, " + enumerated(names);
  if (names.size() > 2) there = std::to_string(names.size()) + " groups, " + enumerated(names);
  throw base::UserError("the column '" + column + "' has " + there + "; two are compared");
}

/// A role and the indices of its columns in the file.
struct ColumnsOfRole {
  const DataColumn* column = nullptr;
  std::vector<std::size_t> columnIndices;
};

std::string optionsOf(std::span<const DataColumn> columns) {
  std::string text;
  for (const auto& column : columns) {
    text += (text.empty() ? "--" : ", --") + std::string(column.role);
  }
  return text;
}

void checkRoles(std::span<const DataColumn> columns, const ChosenColumns& chosen) {
  for (const auto& [role, names] : chosen) {
    const bool isThere = std::ranges::find(columns, role, &DataColumn::role) != columns.end();
    if (!isThere && !names.empty()) {
      throw base::UserError("the test does not use --" + role + "; it uses " + optionsOf(columns));
    }
  }
}

bool isNamed(const ChosenColumns& chosen, std::string_view role) {
  const auto named = chosen.find(std::string(role));
  return named != chosen.end() && !named->second.empty();
}

/// Which columns of the file are used for which role. Where options name all that are needed, no
/// others are used. Otherwise a role without an option has the next column that no option names,
/// an optional role the column of its own name, and none may be left over.
class ColumnChoice {
 public:
  ColumnChoice(
      const CsvTable& table, std::span<const DataColumn> columns, const ChosenColumns& chosen)
      : table_(table), columns_(columns), chosen_(chosen), isUsed_(table.columns.size()) {
    isChosenByOptions_ = std::ranges::all_of(columns, [&](const DataColumn& column) {
      return !column.isRequired || isNamed(chosen, column.role);
    });
  }

  std::vector<ColumnsOfRole> all() {
    std::vector<ColumnsOfRole> roles;
    for (const auto& column : columns_) roles.push_back({.column = &column, .columnIndices = {}});
    for (auto& role : roles) useNamed(role);
    for (auto& role : roles) {
      if (!role.columnIndices.empty()) continue;
      if (role.column->kind == Kind::Numbers) {
        for (std::size_t i = 0; i < table_.columns.size(); ++i) use(role, i);
      } else if (role.column->isRequired) {
        use(role, nextUnused());
      }
    }
    refuseUnused();
    return roles;
  }

 private:
  void use(ColumnsOfRole& role, std::size_t index) {
    role.columnIndices.push_back(index);
    isUsed_[index] = true;
  }

  void useNamed(ColumnsOfRole& role) {
    if (isNamed(chosen_, role.column->role)) {
      for (const auto& name : chosen_.at(std::string(role.column->role))) {
        use(role, table_.columnIndex(name));
      }
    } else if (!role.column->isRequired && !isChosenByOptions_) {
      const auto own = std::ranges::find(table_.columns, role.column->role);
      const auto index = static_cast<std::size_t>(own - table_.columns.begin());
      if (own != table_.columns.end() && !isUsed_[index]) use(role, index);
    }
  }

  std::size_t nextUnused() const {
    const auto next = std::ranges::find(isUsed_, false);
    if (next != isUsed_.end()) return static_cast<std::size_t>(next - isUsed_.begin());
    std::vector<DataColumn> required;
    std::ranges::copy_if(columns_, std::back_inserter(required), &DataColumn::isRequired);
    const auto count = table_.columns.size();
    throw base::UserError(
        "the file has " + std::to_string(count) + (count == 1 ? " column" : " columns") +
        ", and the test needs " + optionsOf(required));
  }

  void refuseUnused() const {
    const auto unused = std::ranges::find(isUsed_, false);
    if (unused == isUsed_.end() || isChosenByOptions_) return;
    throw base::UserError(
        "column '" + table_.columns[static_cast<std::size_t>(unused - isUsed_.begin())] +
        "' is not used: choose the test's columns with " + optionsOf(columns_));
  }

  const CsvTable& table_;
  std::span<const DataColumn> columns_;
  const ChosenColumns& chosen_;
  std::vector<bool> isUsed_;
  bool isChosenByOptions_ = false;
};

/// Reads lines into TestData.
class TestDataReader {
 public:
  TestDataReader(const CsvTable& table, std::vector<ColumnsOfRole> roles, bool isGrouped)
      : table_(table), roles_(std::move(roles)), isGrouped_(isGrouped) {
    for (const auto& role : roles_) {
      const auto kind = role.column->kind;
      if (kind == Kind::Name) data_.names.push_back({std::string(role.column->role), {}});
      if (isGrouped_ || (kind != Kind::Number && kind != Kind::Numbers)) continue;
      for (const auto place : role.columnIndices) {
        data_.values.push_back({.name = table.columns[place], .values = {}});
      }
    }
  }

  TestData all() {
    for (const auto& row : table_.rows) line(row);
    if (!problems_.empty()) throw errorOf(problems_);
    return std::move(data_);
  }

 private:
  void line(const CsvRow& row) {
    std::vector<double> numbers;
    std::vector<std::string> names;
    std::uint64_t count = 1;
    bool isComplete = true;
    for (const auto& role : roles_) {
      for (const auto place : role.columnIndices) {
        const auto& cell = row.cells[place];
        isComplete = isComplete && !isMissing(cell);
        if (role.column->kind == Kind::Name) {
          names.push_back(cell);
        } else if (isComplete) {
          const auto number = numberIn(row.line, cell, role.column->kind == Kind::Count);
          if (role.column->kind == Kind::Count) {
            count = static_cast<std::uint64_t>(number);
          } else {
            numbers.push_back(number);
          }
        }
      }
    }
    // A group whose values are all missing is kept as an empty group.
    if (isGrouped_ && !isMissing(names.front())) group(names.front());
    if (!isComplete) {
      ++data_.missing;
      return;
    }
    if (isGrouped_) {
      group(names.front()).values.push_back(numbers.front());
      return;
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) data_.values[i].values.push_back(numbers[i]);
    for (std::size_t i = 0; i < names.size(); ++i) data_.names[i].values.push_back(names[i]);
    data_.counts.push_back(count);
  }

  NamedValues& group(const std::string& name) {
    const auto found = std::ranges::find(data_.values, name, &NamedValues::name);
    if (found != data_.values.end()) return *found;
    return data_.values.emplace_back(NamedValues{.name = name, .values = {}});
  }

  double numberIn(std::size_t line, const std::string& cell, bool isCount) {
    constexpr double kMostCases = 1e9;
    const auto mark =
        table_.separator == ';' ? base::DecimalMark::PointOrComma : base::DecimalMark::Point;
    const auto number = base::decimalNumber(cell, mark);
    const bool isSound =
        number &&
        (!isCount || (*number >= 0.0 && *number <= kMostCases && *number == std::floor(*number)));
    if (isSound) return *number;
    problems_.push_back(
        isCount ? "line " + std::to_string(line) + ": '" + cell +
                      "' is no number of cases, which is whole and not negative"
                : notANumberMessage(line, cell, table_.separator));
    return 0.0;
  }

  const CsvTable& table_;
  std::vector<ColumnsOfRole> roles_;
  bool isGrouped_;
  TestData data_;
  std::vector<std::string> problems_;
};

}  // namespace

std::span<const DataColumn> columnsOf(DataShape shape) noexcept {
  switch (shape) {
    case DataShape::TwoGroups:
    case DataShape::Groups:
      return kGroupsData;
    case DataShape::Pairs:
      return kPairsData;
    case DataShape::Columns:
      return kColumnsData;
    case DataShape::Values:
      return kValuesData;
    case DataShape::Categories:
    case DataShape::BeforeAfter:
      return kCategoriesData;
    case DataShape::Votes:
      return kVotesData;
    case DataShape::Clusters:
      return kClustersData;
  }
  return {};
}

std::vector<std::vector<double>> TestData::lines() const {
  std::vector<std::vector<double>> result(values.empty() ? 0 : values.front().values.size());
  for (const auto& column : values) {
    for (std::size_t i = 0; i < result.size(); ++i) result[i].push_back(column.values[i]);
  }
  return result;
}

Factor TestData::factor(std::string_view role) const {
  for (const auto& column : names) {
    if (column.role == role) return factorOf(column.role, column.values);
  }
  return {.name = std::string(role), .levels = {}, .levelOfAnswer = {}};
}

ContingencyTable contingencyTableOf(const TestData& data, bool isSquare) {
  auto first = data.names.at(0).values;
  auto second = data.names.at(1).values;
  const auto cases = first.size();
  if (isSquare) {
    const auto ofSecond = second;
    second.insert(second.begin(), first.begin(), first.end());
    first.insert(first.end(), ofSecond.begin(), ofSecond.end());
  }
  const auto rows = factorOf("first", first);
  const auto columns = isSquare ? rows : factorOf("second", second);
  const auto columnOf = [&](std::size_t i) {
    return isSquare ? rows.levelOfAnswer[cases + i] : columns.levelOfAnswer[i];
  };
  ContingencyTable table{
      .rows = rows.levels,
      .columns = columns.levels,
      .counts = {rows.levels.size(), std::vector<std::uint64_t>(columns.levels.size())}};
  for (std::size_t i = 0; i < cases; ++i) {
    table.counts[rows.levelOfAnswer[i]][columnOf(i)] += data.counts[i];
  }
  return table;
}

TestData readTestData(std::string_view csv, DataShape shape, const ChosenColumns& chosen) {
  const CsvTable table = readCsv(csv);
  checkRoles(columnsOf(shape), chosen);
  auto roles = ColumnChoice(table, columnsOf(shape), chosen).all();
  if (table.rows.empty()) throw base::UserError("the file has a header and no rows");
  const bool isGrouped = shape == DataShape::TwoGroups || shape == DataShape::Groups;
  const auto groupColumn =
      isGrouped ? table.columns[roles.front().columnIndices.front()] : std::string();
  auto data = TestDataReader(table, std::move(roles), isGrouped).all();
  if (shape == DataShape::TwoGroups) requireTwoGroups(data.values, groupColumn);
  return data;
}

}  // namespace analysis
