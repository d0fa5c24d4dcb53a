#include <nlohmann/json.hpp>

#include "study/app/planning/published_report.h"

namespace study::app {
namespace {

using Json = nlohmann::ordered_json;
using analysis::PublishedConvention;

Json asJson(const PublishedConvention& convention) {
  const char* test = convention.test == PublishedConvention::Test::Welch          ? "welch"
                     : convention.test == PublishedConvention::Test::WelchToolpak ? "welch-toolpak"
                                                                                  : "student";
  return {
      {"test", test},
      {"tails", convention.tails == PublishedConvention::Tails::Two ? 2 : 1},
      {"variance", convention.divisor == PublishedConvention::Divisor::Sample ? "n-1" : "n"},
      {"digits", convention.rounding == analysis::RoundingRule::Rounded ? "rounded" : "truncated"}};
}

Json asJson(const analysis::PublishedTable& table, const analysis::ConventionCheck& check) {
  Json json{{"convention", asJson(check.convention)}, {"n", check.sizes}};
  json["comparisons"] = Json::array();
  for (std::size_t i = 0; i < check.comparisons.size(); ++i) {
    const auto& [first, second, p] = table.comparisons[i];
    json["comparisons"].push_back(
        {{"group1", table.groups[first].name},
         {"group2", table.groups[second].name},
         {"printed", p.text()},
         {"p_low", check.comparisons[i].attainable.low},
         {"p_high", check.comparisons[i].attainable.high},
         {"follows", check.comparisons[i].isAttainable}});
  }
  json["row"] = nullptr;
  if (check.row) {
    json["row"] = Json::array();
    for (const auto& group : *check.row) {
      json["row"].push_back({{"mean", group.mean}, {"variance", group.variance}});
    }
  }
  return json;
}

Json asJson(const analysis::ConsistentSizes& fits) {
  Json json{
      {"convention", asJson(fits.convention)},
      {"tried", fits.triedCombinations},
      {"fitting", fits.fitting},
      {"equal_n", fits.equalSizes()},
      {"possible_n", fits.possibleSizes}};
  const auto fewest = fits.largestFittingSizes();
  json["fewest_missing"] = fewest ? Json(*fewest) : Json(nullptr);
  json["example"] = fits.exampleAnswers.empty() ? Json(nullptr) : Json(fits.exampleAnswers);
  return json;
}

}  // namespace

std::string publishedReportAsJson(const PublishedReport& report) {
  Json json;
  json["groups"] = Json::array();
  for (const auto& group : report.table.groups) json["groups"].push_back(group.name);
  json["at_stated_n"] = Json::array();
  for (const auto& check : report.statedSizeChecks) {
    json["at_stated_n"].push_back(asJson(report.table, check));
  }
  json["at_equal_n"] = Json::array();
  for (const auto& check : report.equalSizeChecks) {
    json["at_equal_n"].push_back(asJson(report.table, check));
  }
  json["whole_answers"] = Json::array();
  for (const auto& fits : report.consistentSizes) json["whole_answers"].push_back(asJson(fits));
  return json.dump(2) + "\n";
}

}  // namespace study::app
