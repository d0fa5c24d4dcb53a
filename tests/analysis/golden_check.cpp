#include "tests/analysis/golden_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tests {
namespace {

/// The golden value as text; "nan" where there is none.
std::string textOf(const nlohmann::json& golden, const std::string& quantity) {
  const auto entry = golden.find(quantity);
  if (entry == golden.end() || entry->is_null()) return "nan";
  return entry->is_string() ? entry->get<std::string>() : entry->dump();
}

bool canBeHeld(const std::string& truth) {
  if (truth.ends_with("inf")) return true;
  const long double number = std::strtold(truth.c_str(), nullptr);
  return !std::isnan(number) &&
         (number == 0.0L || std::fabs(number) >= std::numeric_limits<double>::min());
}

}  // namespace

void addInterval(
    Quantities& quantities,
    const std::string& name,
    const std::optional<analysis::Interval>& interval) {
  quantities[name + "_lo"] = interval ? std::optional(interval->low) : std::nullopt;
  quantities[name + "_hi"] = interval ? std::optional(interval->high) : std::nullopt;
}

void compareWithGolden(
    const std::string& dataSet,
    const nlohmann::json& golden,
    const Quantities& ours,
    const Gate& gate,
    WorstDigits& worst) {
  for (const auto& [quantity, number] : ours) {
    SCOPED_TRACE(testing::Message() << dataSet << " " << quantity);
    const std::string truth = textOf(golden, quantity);
    EXPECT_EQ(number.has_value(), canBeHeld(truth)) << truth;
    if (!number || !canBeHeld(truth)) continue;
    if (std::isinf(*number)) {
      EXPECT_EQ(std::to_string(*number), truth);
      continue;
    }
    const double digits = correctDigits(*number, truth);
    worst.add(quantity, dataSet, digits);
    EXPECT_GE(digits, gate(quantity)) << *number << " is not " << truth;
  }
}

void compareWithCertified(
    const std::string& dataSet,
    const nlohmann::json& certified,
    const std::map<std::string, double>& ours,
    WorstDigits& worst) {
  constexpr double kMostAsked = 15.0;
  constexpr double kSlack = 0.2;
  for (const auto& [quantity, number] : ours) {
    const double digits =
        std::min(kMostAsked, correctDigits(number, certified[quantity].get<std::string>()));
    worst.add(quantity, dataSet, digits);
    EXPECT_GE(digits, certified["attainable_digits"][quantity].get<double>() - kSlack)
        << dataSet << " " << quantity;
  }
}

}  // namespace tests
