#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "analysis/numerics/interval.h"
#include "tests/analysis/digits.h"

namespace tests {

/// What the golden file calls it → what we say.
using Quantities = std::map<std::string, std::optional<double>>;

/// How many digits of a quantity must be right.
using Gate = std::function<double(const std::string& quantity)>;

/// Adds both ends of an interval: name_lo and name_hi.
void addInterval(
    Quantities& quantities,
    const std::string& name,
    const std::optional<analysis::Interval>& interval);

/// Expects that each of our quantities has the digits asked for; that nothing is said where the
/// golden file has nothing, no number, or one that a double cannot hold; and that infinities have
/// the right sign.
void compareWithGolden(
    const std::string& dataSet,
    const nlohmann::json& golden,
    const Quantities& ours,
    const Gate& gate,
    WorstDigits& worst);

/// Expects of each of our quantities the digits that doubles can attain, as NIST's certified values
/// have them beside themselves ("attainable_digits").
void compareWithCertified(
    const std::string& dataSet,
    const nlohmann::json& certified,
    const std::map<std::string, double>& ours,
    WorstDigits& worst);

}  // namespace tests
