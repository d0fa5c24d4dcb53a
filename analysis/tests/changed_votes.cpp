#include "analysis/tests/changed_votes.h"

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

/// Options that changes connect, directly or through others, have the same number.
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

/// The options without the first of each part.
std::vector<std::size_t> keptOptions(ChangeTable table) {
  const auto parts = partsOf(table);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] != i) kept.push_back(i);  // a part is named by its first option
  }
  return kept;
}

/// S, with d as a last column.
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

/// dᵀ S⁻¹ d of a positive definite S, by elimination: Σ of what is left of dᵢ, squared, over the
/// pivot.
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
  if (changedToYes > kMostTosses || changedToNo > kMostTosses - changedToYes) {
    result.reason = reason("too_many_changes");
    return result;
  }
  const SmallProbability exact = fairCoinP(changedToYes, changedToYes + changedToNo);
  result.p = exact.p;
  result.log10P = exact.log10P;
  if (!exact.p) result.reason = reason("p_too_small");
  const Wide difference = static_cast<Wide>(changedToYes) - static_cast<Wide>(changedToNo);
  const auto changes = static_cast<Wide>(changedToYes) + static_cast<Wide>(changedToNo);
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

}  // namespace analysis
