#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace study {

/// One value for each person; empty if the value is suppressed.
using Values = std::vector<std::string>;

/// A fact about people that an acquaintance may know as well: age, role, cohort.
struct QuasiIdentifier {
  std::string name;
  Values exact;                ///< the answers, a value for each person
  std::vector<Values> levels;  ///< generalised values, from the finest to the coarsest level
};

/// Numbers and sizes of equivalence classes: people with equal values in all columns.
struct ClassSizes {
  std::size_t people = 0;
  std::size_t classes = 0;
  std::size_t smallest = 0;              ///< people in the smallest class; 0 without people
  std::size_t peopleInSmallClasses = 0;  ///< people in classes smaller than k
  std::vector<std::pair<std::string, std::string>>
      smallestClass;  ///< values of the smallest class, by column
  /// By column: how many people have a value that fewer than k people share. The largest number
  /// first; columns without such people are left out.
  std::vector<std::pair<std::string, std::size_t>> causes;
};

/// The released values of one quasi-identifier.
struct ReleasedColumn {
  std::string name;
  std::optional<std::size_t> level;  ///< of QuasiIdentifier::levels; std::nullopt: not released
  Values values;                     ///< a value for each person
};

/// The released values of all quasi-identifiers. Every person has the same values as at least k − 1
/// others.
struct Release {
  std::size_t k = 0;
  ClassSizes before;                    ///< classes of the exact values
  ClassSizes after;                     ///< classes of the released values
  std::vector<ReleasedColumn> columns;  ///< in the order of the quasi-identifiers

  /// The column called @p name; nullptr if there is none.
  const ReleasedColumn* column(std::string_view name) const noexcept;
};

/// Counts the classes of people who have equal values in all @p columns.
/// @throws std::invalid_argument  if columns differ in length.
ClassSizes classSizes(
    const std::vector<ReleasedColumn>& columns, std::size_t people, std::size_t k);

/// @p values after suppressing every value that fewer than @p k people have. If fewer than @p k
///     people are then without a value, the next rarest value is suppressed as well.
Values suppressRareValues(const Values& values, std::size_t k);

/// k-anonymity (Sweeney 2002) by a deterministic greedy search over the quasi-identifiers in the
/// given order. Each quasi-identifier divides the present classes further. Within a class, values
/// that fewer than k people have are suppressed, so that no class becomes smaller than k. For each
/// quasi-identifier, the level with the largest entropy plus share of people who keep a value is
/// released; none is released if that sum is zero for every level. Earlier quasi-identifiers
/// therefore lose the least. All people are kept.
/// @return  std::nullopt if there are fewer people than k.
/// @throws std::invalid_argument  if @p k is below 2, or if a column does not have one value for
///     each person.
std::optional<Release> computeRelease(
    const std::vector<QuasiIdentifier>& identifiers, std::size_t people, std::size_t k);

}  // namespace study
