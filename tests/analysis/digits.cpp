#include "tests/analysis/digits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace tests {

double correctDigits(double number, const std::string& exact) {
  constexpr double kAll = 17.0;
  const long double truth = std::strtold(exact.c_str(), nullptr);
  const long double error = std::fabs(static_cast<long double>(number) - truth);
  if (error == 0.0L) return kAll;
  if (truth == 0.0L) return 0.0;
  return std::min(kAll, static_cast<double>(-std::log10(error / std::fabs(truth))));
}

WorstDigits::~WorstDigits() {
  std::printf("correct digits, %s (%d numbers)\n", title_.c_str(), count_);
  for (const auto& [quantity, worst] : worst_) {
    std::printf("  %-28s %5.1f  %s\n", quantity.c_str(), worst.digits, worst.dataSet.c_str());
  }
}

void WorstDigits::add(const std::string& quantity, const std::string& dataSet, double digits) {
  ++count_;
  const auto [entry, isNew] = worst_.try_emplace(quantity, Worst{digits, dataSet});
  if (!isNew && digits < entry->second.digits) entry->second = {digits, dataSet};
}

}  // namespace tests
