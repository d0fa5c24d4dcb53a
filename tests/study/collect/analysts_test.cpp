// What an analyst may count on the server: conditions by their codes, backgrounds in bands.
#include <map>
#include <set>

#include "study/cohort/simulated_participant.h"
#include "study/collect/exchange/administration.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/server/registry.h"
#include "study/export/coarsening.h"
#include "study/storage/answer_repository.h"
#include "study/storage/protocol_repository.h"
#include "study/storage/statement.h"
#include "tests/study/collect/collected_study_at.h"

namespace analysts_test {

using study::Study;
using study::collect::Connection;
using study::collect::Parameter;
using study::collect::ServerError;

class Analysts : public tests::CollectTest {
 protected:
  Connection analyst() const {
    auto owner = admin();
    if (owner.query("SELECT 1 FROM pg_roles WHERE rolname = 'ada'").isEmpty()) {
      owner.execute("CREATE ROLE ada LOGIN");
    }
    owner.execute("GRANT palpate_analyst TO ada");
    return as("ada");
  }

  /// How often each point was chosen of each condition, at the station itself: "kalman 4".
  std::map<std::string, std::int64_t> countsAt(const std::string& label) {
    const auto account = accountOf(label);
    auto study = Study::open(folderOf(label), clock_, study::storage::Database::Access::ReadOnly);
    study::storage::Statement select(
        study.database(),
        "SELECT l.condition || ' ' || a.point, count(*) FROM answer AS a JOIN allocation AS l "
        "ON l.session_id = a.session_id AND l.step = a.step "
        "WHERE a.point IS NOT NULL AND l.condition <> '' GROUP BY 1");
    std::map<std::string, std::int64_t> counts;
    while (select.step()) counts[select.text(0)] = select.number(1);
    return counts;
  }

  /// The same in the analysts' view, by code.
  static std::map<std::string, std::int64_t> countsIn(Connection& server) {
    const auto rows = server.query(
        "SELECT code || ' ' || point, count(*) FROM palpate.answers WHERE code IS NOT NULL "
        "GROUP BY 1");
    std::map<std::string, std::int64_t> counts;
    for (int i = 0; i < rows.count(); ++i) counts[rows.text(i, 0)] = rows.number(i, 1);
    return counts;
  }

  /// Named by what the owner alone can read.
  static std::map<std::string, std::int64_t> named(
      Connection& owner, const std::map<std::string, std::int64_t>& counts) {
    std::map<std::string, std::int64_t> result;
    for (const auto& [code, count] : counts) {
      const auto space = code.find(' ');
      const auto condition = owner.query(
          "SELECT condition FROM palpate.condition_code WHERE code = $1 AND run_mode = 'simulated'",
          {code.substr(0, space)});
      result[condition.text(0, 0) + code.substr(space)] = count;
    }
    return result;
  }
};

TEST_F(Analysts, CountConditionsByCodesThatTheyCannotRead) {
  addStation("oslo");
  simulate("oslo", 4);
  push("oslo");
  auto ada = analyst();
  auto owner = admin();
  const auto counts = countsIn(ada);
  ASSERT_FALSE(counts.empty());
  EXPECT_EQ(counts.begin()->first.front(), 'C');
  EXPECT_EQ(named(owner, counts), countsAt("oslo"));
  EXPECT_THROW(ada.query("SELECT * FROM palpate.condition_code"), ServerError);
  EXPECT_THROW(ada.query("SELECT code FROM palpate.answer"), ServerError);
}

TEST_F(Analysts, CodesAreDrawnForEachStudyAndRunMode) {
  auto owner = admin();
  std::set<std::string> drawn;
  for (int i = 0; i < 20; ++i) {
    study::collect::addStudyOrVersion(
        owner, "again-" + std::to_string(i), tests::protocolFrom(tests::shortProtocol()), 100 + i);
  }
  const auto rows = owner.query(
      "SELECT study || run_mode, string_agg(code, ' ' ORDER BY condition), "
      "string_agg(code, ' ' ORDER BY code) FROM palpate.condition_code GROUP BY 1");
  ASSERT_EQ(rows.count(), 3 * 21);
  for (int i = 0; i < rows.count(); ++i) {
    drawn.insert(rows.text(i, 1));
    EXPECT_EQ(rows.text(i, 2), "C1 C2 C3");
  }
  EXPECT_EQ(drawn.size(), 6U);  // all arrangements; one is missed in one of 15,000 runs
}

TEST_F(Analysts, CodesStayWhenTheProtocolGetsAnotherCondition) {
  auto owner = admin();
  const std::string map =
      "SELECT string_agg(run_mode || condition || code, ' ' ORDER BY run_mode, condition) "
      "FROM palpate.condition_code WHERE condition <> 'none'";
  const auto before = owner.query(map).text(0, 0);
  study::collect::addStudyOrVersion(
      owner,
      "short",
      tests::protocolFrom(tests::shortProtocol(
          {.conditions = {"interpolation", "finite-elements", "none", "kalman"}})),
      {});
  EXPECT_EQ(owner.query(map).text(0, 0), before);
  const auto added =
      owner.query("SELECT code FROM palpate.condition_code WHERE condition = 'none'");
  ASSERT_EQ(added.count(), 3);
  EXPECT_EQ(added.text(0, 0), "C4");
}

TEST_F(Analysts, SeeBackgroundsInTheBandsOfAnExport) {
  auto owner = admin();
  const auto protocol = tests::protocolFrom(tests::shortProtocol({.form = "background"}));
  study::collect::addStudyOrVersion(owner, "with-form", protocol, 2);
  const auto account = accountOf("oslo");
  const auto station =
      study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
  const auto enrolled = study::collect::enrolStation(
      owner, {.study = "with-form", .site = "oslo", .key = station.publicKey()});
  study::collect::join(scratch_.write("oslo.enrolment", enrolled.file), folderOf("oslo"), clock_);
  simulate("oslo", 6);
  push("oslo");

  std::map<std::string, std::string> told;
  {
    auto study = Study::open(folderOf("oslo"), clock_, study::storage::Database::Access::ReadOnly);
    study::storage::Statement select(
        study.database(),
        "SELECT p.code, a.item, a.kind, a.point, a.number, a.text FROM answer AS a "
        "JOIN session AS s ON s.id = a.session_id JOIN participant AS p ON p.id = s.participant_id "
        "JOIN step AS t ON t.session_id = a.session_id AND t.step = a.step WHERE t.phase = 'form'");
    while (select.step()) {
      const auto* item = protocol.instrument("background")->item(select.text(1));
      if (!study::isQuasiIdentifier(*item)) continue;
      const auto response = study::storage::restored(
          {.kind = select.text(2),
           .point = select.optionalNumber(3),
           .number = select.optionalReal(4),
           .text = select.optionalText(5)});
      told[select.text(0) + " " + item->id] =
          study::GeneralisationHierarchy(*item, "en").releasedValue(0, response);
    }
  }
  auto ada = analyst();
  const auto rows = ada.query("SELECT participant, item, told FROM palpate.backgrounds");
  std::map<std::string, std::string> seen;
  for (int i = 0; i < rows.count(); ++i) {
    seen[rows.text(i, 0) + " " + rows.text(i, 1)] = rows.text(i, 2);
  }
  EXPECT_GT(seen.size(), 6U);
  EXPECT_EQ(seen, told);
  const auto years =
      ada.query("SELECT told FROM palpate.backgrounds WHERE item = 'surgery-years' LIMIT 1");
  ASSERT_EQ(years.count(), 1);
  EXPECT_NE(years.text(0, 0).find(" to "), std::string::npos) << years.text(0, 0);
}

TEST_F(Analysts, BandsHaveTheWordsOfAnExport) {
  auto owner = admin();
  struct Asked {
    double least = 0.0;
    double most = 0.0;
    double step = 0.0;
  };
  for (const auto& [least, most, step] :
       {Asked{0.0, 70.0, 1.0},
        Asked{0.0, 2.0, 0.01},
        Asked{-40.0, 40.0, 0.5},
        Asked{1.0, 9000.0, 1.0}}) {
    questionnaires::Item item;
    item.type = questionnaires::ItemType::Number;
    item.least = least;
    item.most = most;
    item.step = step;
    const study::GeneralisationHierarchy bands(item, "en");
    for (int i = 0; i <= 20; ++i) {
      const double value = least + (most - least) * i / 20.0;
      const auto told = owner.query(
          "SELECT palpate.band($1, $2, $3)",
          {study::exactDecimal(value),
           study::exactDecimal(bands.bandWidth().value_or(0.0)),
           bands.isWhole() ? "true" : "false"});
      EXPECT_EQ(told.text(0, 0), bands.releasedValue(0, value)) << value;
    }
  }
}

}  // namespace analysts_test
