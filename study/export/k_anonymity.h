#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace study {

/// What is said about each person in one respect; empty: nothing is said.
using Values = std::vector<std::string>;

/// Something about people that somebody who knows one of them may know as well: the age, the role,
/// the cohort. (The field says: quasi-identifier.)
struct QuasiIdentifier {
  std::string name;
  Values exact;                ///< as it was answered, a value for each person
  std::vector<Values> levels;  ///< as it may be told, from finest to coarsest
};

/// People of whom the same is said, counted.
struct ClassSizes {
  std::size_t people = 0;
  std::size_t classes = 0;
  std::size_t smallest = 0;  ///< people in the smallest class; 0: there is nobody
  std::size_t inSmall = 0;   ///< people in classes of fewer than k
  std::vector<std::pair<std::string, std::string>>
      smallestClass;  ///< what is said of them, by name
  /// How many people each respect alone puts among fewer than k, the most first; none that puts
  /// nobody there.
  std::vector<std::pair<std::string, std::size_t>> causes;
};

/// What may be told in one respect.
struct ReleasedColumn {
  std::string name;
  std::optional<std::size_t> level;  ///< of QuasiIdentifier::levels; nothing: nothing is told
  Values values;                     ///< a value for each person
};

/// What may be told of some people so that everybody is one of at least k of whom the same is told.
struct Release {
  std::size_t k = 0;
  ClassSizes before;  ///< of exact values
  ClassSizes after;
  std::vector<ReleasedColumn> columns;  ///< as they were given

  const ReleasedColumn* column(std::string_view name) const noexcept;
};

/// Counts the classes of people in which all @p columns agree.
/// @throws std::invalid_argument  if columns differ in length.
ClassSizes classSizes(
    const std::vector<ReleasedColumn>& columns, std::size_t people, std::size_t k);

/// A column in which every value is shared by at least @p k: rarer ones are emptied, and if those
/// that are empty are themselves fewer than @p k, the next rarest with them.
Values withoutRare(const Values& values, std::size_t k);

/// k-anonymity (Sweeney 2002) by a search that gives the same result for the same people: one
/// respect after the other in the order given. Each divides the classes that there are so far; what
/// fewer than k in a class share is emptied there (the field says: local suppression), so that no
/// class is ever smaller than k. Of its levels that one is taken which tells most (Shannon's
/// entropy, and of how many people); none where none tells anything. What comes first is therefore
/// kept best. People are never left out.
/// @return  nothing where there are fewer people than k.
/// @throws std::invalid_argument  if @p k is below 2, or not everybody has a value in each column.
std::optional<Release> released(
    const std::vector<QuasiIdentifier>& identifiers, std::size_t people, std::size_t k);

}  // namespace study
