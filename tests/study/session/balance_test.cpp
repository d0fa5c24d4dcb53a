// A design stays balanced when participants leave.
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "base/random.h"
#include "study/storage/records.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
#include "tests/support/long_form.h"

namespace study {
namespace balance_test {

using Order = std::vector<std::string>;

Order orderOf(const Session& session) {
  Order order;
  for (const auto& step : session.plan()) {
    if (step.kind == StepKind::Trial) order.push_back(step.condition);
  }
  return order;
}

/// The difference between the largest and the smallest count.
template <typename Key>
int spread(const std::map<Key, int>& counts) {
  int least = counts.begin()->second;
  int most = least;
  for (const auto& [key, count] : counts) {
    least = std::min(least, count);
    most = std::max(most, count);
  }
  return most - least;
}

/// A participant who finishes, or is rejected after the first trial.
void takePart(Session& session, bool isRejected) {
  if (!isRejected) {
    tests::walkToTheEnd(session);
    return;
  }
  tests::walkTo(session, StepKind::Trial);
  tests::passStep(session);
  session.reject("did not look at the screen");
}

TEST(Balance, HoldsForHundredsOfParticipantsOfWhomFifteenPercentAreRejected) {
  const int participants = tests::inLongForm(600, 180);
  const auto protocol =
      tests::protocolFrom(tests::shortProtocol({.questionnaire = "", .hasPreference = false}));
  tests::MadeStudy study(protocol, 2026);
  base::RandomStream random(2026, 0, "rejects of the balance test");
  std::map<Order, int> orders;
  std::map<std::pair<std::string, std::string>, int> carryOver;
  int rejected = 0;
  for (int i = 0; i < participants; ++i) {
    auto session = Session::enrol(*study, {.cohort = "surgeons"});
    const bool isRejected = random.uniform() < 0.15;
    takePart(session, isRejected);
    if (isRejected) {
      ++rejected;
      continue;
    }
    const auto order = orderOf(session);
    ++orders[order];
    for (std::size_t k = 1; k < order.size(); ++k) ++carryOver[{order[k - 1], order[k]}];
  }
  // 0.15 n, three standard deviations of √(0.15 · 0.85 n)
  EXPECT_NEAR(rejected, 0.15 * participants, 3.0 * std::sqrt(0.1275 * participants));
  EXPECT_EQ(orders.size(), 6U);  // all orders of three conditions
  EXPECT_LE(spread(orders), 1);  // equally often, except for the unfinished cycle
  EXPECT_EQ(carryOver.size(), 6U);
  EXPECT_LE(spread(carryOver), 2);  // a pair is in two of the six orders
}

TEST(Balance, HoldsExactlyWhenTheLastCycleIsFull) {
  const auto protocol =
      tests::protocolFrom(tests::shortProtocol({.questionnaire = "", .hasPreference = false}));
  tests::MadeStudy study(protocol, 7);
  std::map<Order, int> orders;
  std::map<std::pair<std::string, std::string>, int> carryOver;
  for (int done = 0, i = 0; done < 36; ++i) {
    auto session = Session::enrol(*study, {.cohort = "students"});
    takePart(session, i % 7 == 3);
    if (session.state() != SessionState::Completed) continue;
    ++done;
    const auto order = orderOf(session);
    ++orders[order];
    for (std::size_t k = 1; k < order.size(); ++k) ++carryOver[{order[k - 1], order[k]}];
  }
  EXPECT_EQ(spread(orders), 0);
  EXPECT_EQ(spread(carryOver), 0);
}

TEST(Balance, FillsFreedPlacesFirstWithConcurrentSessions) {
  tests::MadeStudy study;
  std::vector<Session> sessions;
  for (int i = 0; i < 8; ++i) sessions.push_back(Session::enrol(*study, {.cohort = "surgeons"}));
  for (const std::size_t leaver : {5U, 2U, 6U}) sessions[leaver].withdraw("");
  for (const std::int64_t hole : {2, 5, 6, 8}) {
    sessions.push_back(Session::enrol(*study, {.cohort = "surgeons"}));
    EXPECT_EQ(sessions.back().slot(), hole);
  }
}

TEST(Balance, GoesOnAfterAnAmendmentThatLeavesTheOrders) {
  const auto version = [](const tests::ShortProtocol& options) {
    return tests::protocolFrom(tests::shortProtocol(options));
  };
  tests::MadeStudy study(version({.questionnaire = ""}));
  const auto nextPlace = [&] { return Session::enrol(*study, {.cohort = "surgeons"}).slot(); };
  EXPECT_EQ(nextPlace(), 0);
  EXPECT_EQ(nextPlace(), 1);
  study->amend(version({.questionnaire = "", .hasPreference = false}), "no preference");
  EXPECT_EQ(nextPlace(), 2);
  study->amend(version({.order = "complete", .questionnaire = ""}), "all orders");
  EXPECT_EQ(nextPlace(), 0) << "another design";
  study->amend(version({.questionnaire = "", .minimumCuts = 2}), "as before");
  EXPECT_EQ(nextPlace(), 3);
}

}  // namespace balance_test
}  // namespace study
