#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace study {

/// One value for each person; an empty value is suppressed.
using Values = std::vector<std::string>;

/// A fact about people that an acquaintance may know as well: age, role, cohort.
struct QuasiIdentifier {
  std::string name;
  Values exact;                ///< as answered, a value for each person
  std::vector<Values> levels;  ///< generalised, from the finest to the coarsest level
};

/// The equivalence classes of people who have the same values in all columns, counted.
struct ClassSizes {
  std::size_t people = 0;
  std::size_t classes = 0;
  std::size_t smallest = 0;              ///< people in the smallest class; 0: there are no people
  std::size_t peopleInSmallClasses = 0;  ///< people in classes smaller than k
  std::vector<std::pair<std::string, std::string>>
      smallestClass;  ///< the values of the smallest class, by column
  /// For each single column, how many people have a value that fewer than k people share. The
  /// largest number first; columns without such people are left out.
  std::vector<std::pair<std::string, std::size_t>> causes;
};

/// The released values of one quasi-identifier.
struct ReleasedColumn {
  std::string name;
  std::optional<std::size_t> level;  ///< of QuasiIdentifier::levels; std::nullopt: not released
  Values values;                     ///< a value for each person
};

/// The released values of all quasi-identifiers: every person has the same values as at least k − 1
/// others.
struct Release {
  std::size_t k = 0;
  ClassSizes before;  ///< of exact values
  ClassSizes after;
  std::vector<ReleasedColumn> columns;  ///< in the order of the quasi-identifiers

  const ReleasedColumn* column(std::string_view name) const noexcept;
};

/// Counts the classes of people in which all @p columns agree.
/// @throws std::invalid_argument  if columns differ in length.
ClassSizes classSizes(
    const std::vector<ReleasedColumn>& columns, std::size_t people, std::size_t k);

/// A column in which every value has at least @p k people: rarer values are suppressed. If fewer
/// than @p k people are then without a value, the next rarest value is suppressed as well.
Values suppressRareValues(const Values& values, std::size_t k);

/// k-anonymity (Sweeney 2002) by a deterministic greedy search over the quasi-identifiers in the
/// order given. Each of them divides the present classes further. Values that fewer than k people
/// of a class share are suppressed there, so that no class is ever smaller than k. The level with
/// the most information is released (entropy plus the share of people who keep a value), or none if
/// no level has information. Earlier quasi-identifiers therefore lose the least. People are never
/// left out.
/// @return  std::nullopt if there are fewer people than k.
/// @throws std::invalid_argument  if @p k is below 2, or a column does not have a value for each
///     person.
std::optional<Release> released(
    const std::vector<QuasiIdentifier>& identifiers, std::size_t people, std::size_t k);

}  // namespace study
