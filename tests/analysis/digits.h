#pragma once

#include <map>
#include <string>

namespace tests {

/// How many digits of a number are right: −log₁₀ of its relative error, 17 where it is exact.
/// @param exact  a decimal string; all its digits count.
double correctDigits(double number, const std::string& exact);

/// Collects for each quantity the data set with the fewest correct digits.
class WorstDigits {
 public:
  explicit WorstDigits(std::string title) : title_(std::move(title)) {}
  /// Prints the worst of each quantity.
  ~WorstDigits();
  WorstDigits(const WorstDigits&) = delete;
  WorstDigits& operator=(const WorstDigits&) = delete;

  void add(const std::string& quantity, const std::string& dataSet, double digits);
  /// How often a number was compared.
  int count() const noexcept { return count_; }

 private:
  struct Worst {
    double digits = 0.0;
    std::string dataSet;
  };
  std::string title_;
  std::map<std::string, Worst> worst_;
  int count_ = 0;
};

}  // namespace tests
