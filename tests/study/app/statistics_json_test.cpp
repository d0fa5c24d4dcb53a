// The statistics table of an export holds what `palpate stats run --json` says, digit by digit.
#include <functional>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "study/app/json_file.h"
#include "study/cohort/simulated_participant.h"
#include "study/export/condition_codes.h"
#include "study/export/statistics_table.h"
#include "tests/study/made_study.h"

namespace study {
namespace statistics_json_test {

using nlohmann::json;

using TableRow = std::map<std::string, Cell>;

/// Simulated participants, an equivalence bound, scores, and items with a threshold.
class StatisticsJson : public testing::Test {
 protected:
  explicit StatisticsJson(int people = 12, bool areAtTwoSites = false) {
    auto text = tests::shortProtocol({.form = "simulator-realism"});
    const std::string alpha = R"("alpha": 0.05)";
    text.insert(text.find(alpha), R"("equivalence_bound": 0.5, )");
    study_.emplace(tests::protocolFrom(text));
    simulateCohorts(**study_, study_->clock, people, 3, [](const auto&) {});
    if (areAtTwoSites) {
      (*study_)->database().execute(
          "UPDATE session SET site = CASE WHEN id % 4 < 2 THEN 'bergen' ELSE 'oslo' END");
    }
    compute();
    codes_ = conditionCodes(**study_, RunMode::Simulated);
  }

  /// Computes the results of the present study in both forms.
  void compute() {
    rows_.clear();
    const ExportOptions options{.runMode = RunMode::Simulated, .isBlinded = false};
    const std::vector<Results> results{computeResults(**study_, RunMode::Simulated)};
    json_ = json::parse(app::resultsAsJson(**study_, results.front()));
    const auto table = statisticsTable(**study_, options, results);
    for (const auto& cells : table.rows) {
      auto& row = rows_.emplace_back();
      for (std::size_t i = 0; i < cells.size(); ++i) row[table.columns[i].name] = cells[i];
    }
  }

  /// The only row of a method that has all values in @p with.
  TableRow row(const std::string& method, const std::map<std::string, std::string>& with) const {
    std::vector<TableRow> found;
    for (const auto& one : rows_) {
      bool fits = one.at("method") == Cell(method);
      for (const auto& [column, value] : with) {
        fits = fits && one.at(column) == (value.empty() ? Cell() : Cell(value));
      }
      if (fits) found.push_back(one);
    }
    EXPECT_EQ(found.size(), 1U) << method;
    return found.empty() ? TableRow{} : found.front();
  }

  /// Expects the same double, or a missing value in both.
  void expectSame(const Cell& cell, const json& number, const std::string& what) {
    if (number.is_null()) {
      EXPECT_EQ(cell, Cell()) << what;
      return;
    }
    const auto* real = std::get_if<double>(&cell);
    const auto* whole = std::get_if<std::int64_t>(&cell);
    ASSERT_TRUE(real != nullptr || whole != nullptr) << what;
    EXPECT_EQ(real != nullptr ? *real : static_cast<double>(*whole), number.get<double>()) << what;
    ++compared_;
  }

  std::optional<tests::MadeStudy> study_;
  json json_;
  std::vector<TableRow> rows_;
  std::map<std::string, std::string> codes_;
  int compared_ = 0;
};

TEST_F(StatisticsJson, MatchesTheTableInEveryComparisonWithinPeople) {
  for (const auto& cohort : json_["families"][0]["cohorts"]) {
    for (const auto& pair : cohort["within"]["comparisons"]) {
      const std::map<std::string, std::string> which{
          {"cohort", cohort["cohort"]},
          {"group1", codes_.at(pair["group1"])},
          {"group2", codes_.at(pair["group2"])}};
      expectSame(row("bayes_factor", which).at("effect"), pair["bf10"], "BF10");
      const auto tost = row("tost", which);
      expectSame(tost.at("p"), pair["tost"]["p"], "TOST");
      expectSame(tost.at("equivalence_bound"), pair["tost"]["bound"], "bound");
      const auto rank = row("signed_rank", which);
      expectSame(rank.at("estimate"), pair["hodges_lehmann"], "Hodges-Lehmann");
      expectSame(rank.at("effect"), pair["signed_rank"]["rank_biserial"], "rank biserial");
    }
  }
  EXPECT_EQ(compared_, 2 * 5);
}

TEST_F(StatisticsJson, MatchesTheTableInOverallTestsAndTheScale) {
  for (const auto& cohort : json_["families"][0]["cohorts"]) {
    const std::map<std::string, std::string> which{{"cohort", cohort["cohort"]}};
    const auto friedman = row("friedman", which);
    expectSame(friedman.at("p_permutation"), cohort["within"]["friedman"]["p_exact"], "Friedman");
    const auto anova = row("rm_anova", which);
    const auto& within = cohort["within"]["anova"];
    expectSame(anova.at("epsilon"), within["greenhouse_geisser"], "epsilon");
    expectSame(anova.at("p_epsilon"), within["p_greenhouse_geisser"], "p with epsilon");
    for (const auto& method : cohort["scale"]) {
      const auto omega =
          row("omega_total",
              {{"cohort", cohort["cohort"]}, {"group1", codes_.at(method["condition"])}});
      expectSame(omega.at("effect"), method["omega_total"], "omega");
      const bool hasReason = omega.at("reason") != Cell();
      EXPECT_EQ(hasReason, method["omega_is_improper"] || !method["omega_reason"].is_null());
    }
  }
  EXPECT_GE(compared_, 2 * 3);
}

TEST_F(StatisticsJson, MatchesTheTableInScoresAndThresholds) {
  for (const auto& instrument : json_["instruments"]) {
    const auto whichOf = [&](const json& one) {
      std::map<std::string, std::string> which{
          {"cohort", one["cohort"]}, {"instrument", instrument["instrument"]}};
      which["group1"] = one["condition"].is_null() ? "" : codes_.at(one["condition"]);
      return which;
    };
    for (const auto& score : instrument["scores"]) {
      auto which = whichOf(score);
      which["score"] = score["score"];
      which["occasion"] = score["occasion"].is_null() ? "" : score["occasion"];
      const auto found = row("score", which);
      expectSame(found.at("n1"), score["n"], "n");
      expectSame(found.at("n_missing"), score["missing"], "missing");
      expectSame(found.at("mean1"), score["mean"], "mean");
      expectSame(found.at("sd1"), score["sd"], "sd");
      if (score["conf"].is_null()) continue;
      expectSame(found.at("conf_low"), score["conf"][0], "conf_low");
      expectSame(found.at("conf_high"), score["conf"][1], "conf_high");
    }
    for (const auto& item : instrument["acceptable"]) {
      auto which = whichOf(item);
      which["item_id"] = item["item"];
      const auto found = row("acceptability", which);
      expectSame(found.at("n1"), item["n"], "n");
      expectSame(found.at("effect"), item["share"], "share");
      expectSame(found.at("acceptable_from"), item["from"], "from");
    }
  }
  EXPECT_GT(compared_, 30);
}

TEST_F(StatisticsJson, MatchesTheTableInEveryItem) {
  ASSERT_FALSE(json_["items"].empty());
  for (const auto& item : json_["items"]) {
    std::map<std::string, std::string> which{
        {"cohort", item["cohort"]}, {"instrument", item["instrument"]}, {"item_id", item["item"]}};
    which["group1"] = item["condition"].is_null() ? "" : codes_.at(item["condition"]);
    if (item.contains("mean")) {
      const auto found = row("item", which);
      expectSame(found.at("n1"), item["n"], "n");
      expectSame(found.at("mean1"), item["mean"], "mean");
      expectSame(found.at("sd1"), item["sd"], "sd");
      expectSame(found.at("estimate"), item["median"], "median");
    }
    if (!item.contains("options")) continue;
    for (const auto& [option, times] : item["options"].items()) {
      which["option"] = option;
      const auto found = row("item_option", which);
      expectSame(found.at("n1"), item["answers"], "answers");
      const json share = times.get<double>() / item["answers"].get<double>();
      expectSame(found.at("effect"), share, "share");
    }
  }
  EXPECT_GT(compared_, 30);
}

TEST_F(StatisticsJson, MatchesTheTableInTheManipulationCheck) {
  EXPECT_EQ(rows_.front().count("site"), 0U);  // all took part at one
  ASSERT_EQ(json_["felt_differences"].size(), 3U);
  for (const auto& felt : json_["felt_differences"]) {
    const auto found =
        row("felt_difference",
            {{"group1", codes_.at(felt["condition1"])}, {"group2", codes_.at(felt["condition2"])}});
    expectSame(found.at("n1"), felt["n"], "n");
    expectSame(found.at("estimate"), felt["rms_mean"], "mean");
    expectSame(found.at("effect"), felt["rms_pooled"], "pooled");
    expectSame(found.at("conf_low"), felt["conf"][0], "conf_low");
    expectSame(found.at("conf_high"), felt["conf"][1], "conf_high");
  }
  EXPECT_EQ(compared_, 3 * 5);
}

class StatisticsJsonOfSites : public StatisticsJson {
 protected:
  StatisticsJsonOfSites() : StatisticsJson(8, true) {}
};

TEST_F(StatisticsJsonOfSites, MatchesTheTableInTheAnswersAndDifferencesOfEachSite) {
  for (const auto& cohort : json_["families"][0]["cohorts"]) {
    const auto& sites = cohort["by_site"];
    for (const auto& site : sites["sites"]) {
      for (const auto& condition : site["conditions"]) {
        const auto found =
            row("site_answers",
                {{"cohort", cohort["cohort"]},
                 {"site", site["site"]},
                 {"group1", codes_.at(condition["condition"])}});
        expectSame(found.at("n1"), condition["n"], "n");
        expectSame(found.at("mean1"), condition["mean"], "mean");
      }
    }
    for (const auto& pair : sites["comparisons"]) {
      std::map<std::string, std::string> which{
          {"cohort", cohort["cohort"]},
          {"site", ""},
          {"group1", codes_.at(pair["group1"])},
          {"group2", codes_.at(pair["group2"])}};
      const auto pooled = row("pooled_sites", which);
      const auto& diamond = pair["reml_knapp_hartung"];
      expectSame(pooled.at("estimate"), diamond["estimate"], "pooled");
      expectSame(pooled.at("conf_low"), diamond["conf"][0], "pooled conf_low");
      expectSame(pooled.at("p"), diamond["p"], "pooled p");
      expectSame(pooled.at("effect"), diamond["i2"], "I2");
      for (const auto& site : pair["sites"]) {
        which["site"] = site["site"];
        const auto found = row("site_difference", which);
        expectSame(found.at("n1"), site["n"], "n");
        expectSame(found.at("estimate"), site["difference"], "difference");
        expectSame(found.at("se"), site["se"], "se");
        expectSame(found.at("conf_high"), site["conf"][1], "conf_high");
      }
    }
  }
  // Two cohorts; two conditions at two sites; one pair, pooled and at two sites.
  EXPECT_EQ(compared_, 2 * (2 * 2 * 2 + 4 + 2 * 4));
}

TEST_F(StatisticsJson, LeavesADamagedTraceOutWithAReason) {
  (*study_)->traces().database().execute(
      "UPDATE chunk SET data = zeroblob(8) WHERE rowid = (SELECT min(rowid) FROM chunk)");
  compute();
  EXPECT_TRUE(json_["felt_differences"].is_null());
  const auto& reason = json_["felt_differences_reason"];
  EXPECT_NE(reason.get<std::string>().find("damaged"), std::string::npos) << reason;
  const auto felt = row("felt_difference", {});
  EXPECT_EQ(felt.at("reason"), Cell(reason.get<std::string>()));
  EXPECT_EQ(felt.at("estimate"), Cell());
  EXPECT_FALSE(json_["families"].empty());
  EXPECT_GT(rows_.size(), 20U);
}

}  // namespace statistics_json_test
}  // namespace study
