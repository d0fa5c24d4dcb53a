#include "analysis/hypothesis_tests/contingency_tables.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>

#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/fair_coin.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

using ChangeTable = std::span<const std::vector<std::uint64_t>>;

void requireSquare(ChangeTable table) {
  constexpr std::size_t kMostChoices = 100;
  constexpr std::uint64_t kMostCount = (std::uint64_t{1} << 32) - 1;
  if (table.size() < 2 || table.size() > kMostChoices) {
    throw std::invalid_argument("a table of changes has 2 to 100 options");
  }
  for (const auto& row : table) {
    if (row.size() != table.size()) throw std::invalid_argument("a table of changes is square");
    if (std::ranges::max(row) > kMostCount) throw std::invalid_argument("a count is too large");
  }
}

/// The connected components of the graph in which two options are joined if an answer changed
/// between them: for each option, the first option of its component.
std::vector<std::size_t> partsOf(ChangeTable table) {
  std::vector<std::size_t> parts(table.size());
  std::iota(parts.begin(), parts.end(), std::size_t{0});
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t j = 0; j < table.size(); ++j) {
      if (i == j || table[i][j] == 0 || parts[i] == parts[j]) continue;
      std::ranges::replace(parts, std::max(parts[i], parts[j]), std::min(parts[i], parts[j]));
    }
  }
  return parts;
}

/// All options except the first one of each part.
std::vector<std::size_t> keptOptions(ChangeTable table) {
  const auto parts = partsOf(table);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] != i) kept.push_back(i);  // a part is named by its first option
  }
  return kept;
}

/// The matrix S, augmented by d as the last column.
using Equations = std::vector<std::vector<DoubleDouble>>;

Equations equationsOf(ChangeTable table, const std::vector<std::size_t>& kept) {
  Equations equations;
  for (const std::size_t i : kept) {
    double difference = 0.0;
    double changes = 0.0;
    for (std::size_t j = 0; j < table.size(); ++j) {
      if (i == j) continue;
      difference += static_cast<double>(table[i][j]) - static_cast<double>(table[j][i]);
      changes += static_cast<double>(table[i][j]) + static_cast<double>(table[j][i]);
    }
    std::vector<DoubleDouble> row;
    row.reserve(kept.size() + 1);
    for (const std::size_t j : kept) {
      row.emplace_back(
          i == j ? changes : -static_cast<double>(table[i][j]) - static_cast<double>(table[j][i]));
    }
    row.emplace_back(difference);
    equations.push_back(std::move(row));
  }
  return equations;
}

/// dᵀ S⁻¹ d of a positive definite S by Gaussian elimination: the sum of dᵢ² / pivot, with dᵢ after
/// the elimination of the rows above.
double quadraticForm(Equations equations) {
  DoubleDouble sum;
  for (std::size_t pivot = 0; pivot < equations.size(); ++pivot) {
    const auto& top = equations[pivot];
    sum = sum + top.back() * top.back() / top[pivot];
    for (std::size_t i = pivot + 1; i < equations.size(); ++i) {
      const DoubleDouble factor = equations[i][pivot] / top[pivot];
      for (std::size_t j = pivot; j < top.size(); ++j) {
        equations[i][j] = equations[i][j] - factor * top[j];
      }
    }
  }
  return sum.high;
}

}  // namespace

McNemarResult mcNemarTest(std::uint64_t changedToYes, std::uint64_t changedToNo) {
  McNemarResult result;
  result.changedToYes = changedToYes;
  result.changedToNo = changedToNo;
  if (changedToYes == 0 && changedToNo == 0) {
    result.reason = reason("nobody_changed");
    return result;
  }
  if (changedToYes > kMostBinomialTrials || changedToNo > kMostBinomialTrials - changedToYes) {
    result.reason = reason("too_many_changes");
    return result;
  }
  const SmallProbability exact = symmetricBinomialP(changedToYes, changedToYes + changedToNo);
  result.p = exact.p;
  result.log10P = exact.log10P;
  if (!exact.p) result.reason = reason("p_too_small");
  const Int128 difference = static_cast<Int128>(changedToYes) - static_cast<Int128>(changedToNo);
  const auto changes = static_cast<Int128>(changedToYes) + static_cast<Int128>(changedToNo);
  result.chiSquared = exactQuotient(difference * difference, changes).high;
  result.pAsymptotic = chiSquaredP(*result.chiSquared, 1.0);
  return result;
}

StuartMaxwellResult stuartMaxwellTest(ChangeTable table) {
  requireSquare(table);
  StuartMaxwellResult result;
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t j = 0; j < table.size(); ++j) {
      result.persons += table[i][j];
      if (i != j) result.changed += table[i][j];
    }
  }
  if (result.changed == 0) {
    result.reason = result.persons == 0 ? reason("nobody_voted") : reason("nobody_changed");
    return result;
  }
  const auto kept = keptOptions(table);
  result.chiSquared = quadraticForm(equationsOf(table, kept));
  result.degreesOfFreedom = static_cast<double>(kept.size());
  result.p = chiSquaredP(*result.chiSquared, *result.degreesOfFreedom);
  result.log10P = log10ChiSquaredP(*result.chiSquared, *result.degreesOfFreedom);
  return result;
}

namespace {

using Counts = std::vector<std::uint64_t>;
constexpr std::uint64_t kLargestTotal = 300;
constexpr std::uint64_t kMostTables = 500'000;
constexpr std::uint64_t kMostInACell = std::uint64_t{1} << 32;
// Relative difference below which probabilities of 31 digits count as equal.
constexpr double kEqualProbability = 1e-20;

const auto& preciseBinomials() {
  static const auto table = binomialCoefficients<DoubleDouble>(kLargestTotal);
  return table;
}

/// Enumerates all tables with given margins, column by column and row by row. Of the count w that a
/// column still lacks, each row gets a part with the hypergeometric probability
///
///     P(part) = C(h, part) C(o, w − part) / C(h + o, w),
///
/// with h the remaining count of this row for this and later columns, and o that of the rows below
/// it.
class TableEnumeration {
 public:
  TableEnumeration(const Counts& rows, const Counts& columns, const DoubleDouble& observed)
      : rows_(rows), columns_(columns), observed_(observed) {}

  /// The probability of tables that are not more probable than the observed one; std::nullopt if
  /// there are too many tables.
  std::optional<double> sumOfNotMoreProbable() {
    std::uint64_t left = 0;
    for (const auto row : rows_) left += row;
    fill(0, 0, columns_.front(), left, 1.0);
    if (visitedTables_ > kMostTables) return std::nullopt;
    return std::min(1.0, sum_.high);
  }

 private:
  /// Tries all counts of cell (@p i, @p j). @p wanted is the count that the column still lacks, @p
  /// below the remaining count of this row and those below it.
  void fill(
      std::size_t j, std::size_t i, std::uint64_t wanted, std::uint64_t below, DoubleDouble p) {
    if (visitedTables_ > kMostTables) return;
    if (j == columns_.size()) return visit(p);
    const std::uint64_t here = rows_[i];
    const std::uint64_t others = below - here;
    if (i + 1 == rows_.size()) {
      rows_[i] -= wanted;
      next(j, p);
      rows_[i] = here;
      return;
    }
    const std::uint64_t least = wanted > others ? wanted - others : 0;
    for (std::uint64_t part = least; part <= std::min(here, wanted); ++part) {
      rows_[i] = here - part;
      fill(
          j,
          i + 1,
          wanted - part,
          others,
          p * preciseBinomials()[here][part] * preciseBinomials()[others][wanted - part] /
              preciseBinomials()[below][wanted]);
    }
    rows_[i] = here;
  }

  void next(std::size_t j, const DoubleDouble& p) {
    std::uint64_t left = 0;
    for (const auto row : rows_) left += row;
    fill(j + 1, 0, j + 1 < columns_.size() ? columns_[j + 1] : 0, left, p);
  }

  void visit(const DoubleDouble& p) {
    ++visitedTables_;
    const bool isMore = (p - observed_).high > kEqualProbability * observed_.high;
    if (!isMore) sum_ = sum_ + p;
  }

  Counts rows_;
  Counts columns_;
  DoubleDouble observed_;
  DoubleDouble sum_;
  std::uint64_t visitedTables_ = 0;
};

/// The sums of each row and column.
struct Margins {
  Counts rows;
  Counts columns;
  std::uint64_t total = 0;
};

Margins marginsOf(std::span<const Counts> table) {
  Margins margins;
  margins.columns.assign(table.front().size(), 0);
  for (const auto& row : table) {
    margins.rows.push_back(std::accumulate(row.begin(), row.end(), std::uint64_t{0}));
    margins.total += margins.rows.back();
    for (std::size_t j = 0; j < row.size(); ++j) margins.columns[j] += row[j];
  }
  return margins;
}

/// The probability of a table among those with its margins.
DoubleDouble probabilityOf(std::span<const Counts> table, const Margins& margins) {
  Counts left = margins.rows;
  std::uint64_t all = margins.total;
  DoubleDouble p = 1.0;
  for (std::size_t j = 0; j < margins.columns.size(); ++j) {
    p = p / preciseBinomials()[all][margins.columns[j]];
    all -= margins.columns[j];
    for (std::size_t i = 0; i < left.size(); ++i) {
      p = p * preciseBinomials()[left[i]][table[i][j]];
      left[i] -= table[i][j];
    }
  }
  return p;
}

}  // namespace

FisherExactResult fisherExactTest(std::span<const Counts> table) {
  if (table.empty()) throw std::invalid_argument("a table has rows");
  for (const auto& row : table) {
    if (row.empty() || row.size() != table.front().size()) {
      throw std::invalid_argument("the rows of a table have as many counts");
    }
    if (std::ranges::max(row) > kMostInACell) throw std::invalid_argument("a count is too large");
  }
  Margins margins = marginsOf(table);
  FisherExactResult result;
  result.total = margins.total;
  const auto nonEmptyCount = [](const Counts& sums) {
    return std::ranges::count_if(sums, [](std::uint64_t sum) { return sum > 0; });
  };
  if (nonEmptyCount(margins.rows) < 2 || nonEmptyCount(margins.columns) < 2) {
    result.reason = reason("one_row_or_column");
    return result;
  }
  if (margins.total > kLargestTotal) {
    result.reason = reason("too_many_counts");
    return result;
  }
  const DoubleDouble observed = probabilityOf(table, margins);
  std::erase(margins.rows, 0U);
  std::erase(margins.columns, 0U);
  result.p = TableEnumeration(margins.rows, margins.columns, observed).sumOfNotMoreProbable();
  if (!result.p) result.reason = reason("too_many_tables");
  return result;
}

}  // namespace analysis
