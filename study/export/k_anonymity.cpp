#include "study/export/k_anonymity.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace study {
namespace {

std::map<std::string, std::size_t> countsOf(const Values& values) {
  std::map<std::string, std::size_t> counts;
  for (const auto& value : values) ++counts[value];
  return counts;
}

/// The information in a column: Σ p (1 − ln p) over the shares p of its non-empty values. This is
/// Shannon's entropy [nats] plus the share of people who have a value.
double informationIn(const Values& values) {
  double sum = 0.0;
  for (const auto& [value, count] : countsOf(values)) {
    if (value.empty()) continue;
    const double share = static_cast<double>(count) / static_cast<double>(values.size());
    sum += share * (1.0 - std::log(share));
  }
  return sum;
}

/// The values of one person in each column.
std::vector<std::string> valuesOf(const std::vector<ReleasedColumn>& columns, std::size_t person) {
  std::vector<std::string> combination;
  combination.reserve(columns.size());
  for (const auto& column : columns) combination.push_back(column.values[person]);
  return combination;
}

std::map<std::vector<std::string>, std::size_t> classesOf(
    const std::vector<ReleasedColumn>& columns, std::size_t people) {
  std::map<std::vector<std::string>, std::size_t> classes;
  for (std::size_t person = 0; person < people; ++person) ++classes[valuesOf(columns, person)];
  return classes;
}

std::vector<std::pair<std::string, std::size_t>> causesIn(
    const std::vector<ReleasedColumn>& columns, std::size_t k) {
  std::vector<std::pair<std::string, std::size_t>> causes;
  for (const auto& column : columns) {
    std::size_t rare = 0;
    for (const auto& [value, count] : countsOf(column.values)) rare += count < k ? count : 0;
    if (rare > 0) causes.emplace_back(column.name, rare);
  }
  std::ranges::stable_sort(
      causes, [](const auto& a, const auto& b) { return a.second > b.second; });
  return causes;
}

void requireOnePerPerson(const Values& values, std::size_t people) {
  if (values.size() != people) throw std::invalid_argument("a column lacks somebody's value");
}

/// @p values after suppression of rare values within every class of people with equal values in
///     @p chosen.
Values suppressRareInClasses(
    const std::vector<ReleasedColumn>& chosen, const Values& values, std::size_t k) {
  std::map<std::vector<std::string>, std::vector<std::size_t>> classes;
  for (std::size_t person = 0; person < values.size(); ++person) {
    classes[valuesOf(chosen, person)].push_back(person);
  }
  Values kept(values.size());
  for (const auto& [combination, members] : classes) {
    Values theirs;
    for (const auto person : members) theirs.push_back(values[person]);
    theirs = suppressRareValues(theirs, k);
    for (std::size_t i = 0; i < members.size(); ++i) kept[members[i]] = theirs[i];
  }
  return kept;
}

/// The level of @p identifier with the most information after suppression within the classes of
/// @p chosen; the finer one of levels with equal information.
ReleasedColumn mostInformativeLevel(
    const std::vector<ReleasedColumn>& chosen, const QuasiIdentifier& identifier, std::size_t k) {
  const std::size_t people = identifier.exact.size();
  ReleasedColumn best{
      .name = identifier.name, .level = std::nullopt, .values = Values(people, std::string())};
  double most = 0.0;
  for (std::size_t level = 0; level < identifier.levels.size(); ++level) {
    requireOnePerPerson(identifier.levels[level], people);
    auto values = suppressRareInClasses(chosen, identifier.levels[level], k);
    const double information = informationIn(values);
    if (information <= most + 1e-9) continue;  // not more than before, except for rounding errors
    most = information;
    best.level = level;
    best.values = std::move(values);
  }
  return best;
}

}  // namespace

const ReleasedColumn* Release::column(std::string_view name) const noexcept {
  const auto found =
      std::ranges::find_if(columns, [&](const auto& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

ClassSizes classSizes(
    const std::vector<ReleasedColumn>& columns, std::size_t people, std::size_t k) {
  for (const auto& column : columns) requireOnePerPerson(column.values, people);
  ClassSizes sizes{.people = people, .causes = causesIn(columns, k)};
  for (const auto& [combination, count] : classesOf(columns, people)) {
    ++sizes.classes;
    if (count < k) sizes.peopleInSmallClasses += count;
    if (sizes.smallest != 0 && count >= sizes.smallest) continue;
    sizes.smallest = count;
    sizes.smallestClass.clear();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (!combination[i].empty())
        sizes.smallestClass.emplace_back(columns[i].name, combination[i]);
    }
  }
  return sizes;
}

Values suppressRareValues(const Values& values, std::size_t k) {
  std::vector<std::pair<std::size_t, std::string>> rarestFirst;
  std::size_t emptied = 0;
  for (const auto& [value, count] : countsOf(values)) {
    if (value.empty()) {
      emptied += count;
    } else {
      rarestFirst.emplace_back(count, value);
    }
  }
  std::ranges::sort(rarestFirst);
  std::map<std::string, bool> isEmptied;
  for (const auto& [count, value] : rarestFirst) {
    if (count >= k && (emptied == 0 || emptied >= k)) break;
    isEmptied[value] = true;
    emptied += count;
  }
  Values kept = values;
  for (auto& value : kept) {
    if (isEmptied.count(value) == 1) value.clear();
  }
  return kept;
}

std::optional<Release> computeRelease(
    const std::vector<QuasiIdentifier>& identifiers, std::size_t people, std::size_t k) {
  if (k < 2) throw std::invalid_argument("one person alone is no class to hide in");
  if (people < k) return std::nullopt;
  Release release{.k = k, .before = {}, .after = {}, .columns = {}};
  std::vector<ReleasedColumn> exact;
  for (const auto& identifier : identifiers) {
    requireOnePerPerson(identifier.exact, people);
    exact.push_back({.name = identifier.name, .level = std::nullopt, .values = identifier.exact});
    release.columns.push_back(mostInformativeLevel(release.columns, identifier, k));
  }
  release.before = classSizes(exact, people, k);
  release.after = classSizes(release.columns, people, k);
  return release;
}

}  // namespace study
