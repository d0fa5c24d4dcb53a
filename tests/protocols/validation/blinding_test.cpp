// What in a protocol says which condition an answer is about, although it bears a code.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/validation/validation.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace blinding_test {

using Words = std::vector<std::string>;

/// Path and key of everything that is found.
Words foundIn(std::string_view json) {
  Words found;
  for (const auto& disclosure : disclosuresOf(tests::soundProtocol(json))) {
    EXPECT_EQ(disclosure.fix.key(), std::string(disclosure.what.key()) + ".fix");
    found.push_back(disclosure.path + " " + std::string(disclosure.what.key()));
  }
  return found;
}

std::string ordered(const std::string& type) {
  return tests::with(tests::usualProtocol(), "balancedLatinSquare", type);
}

/// usualProtocol(), which has a block 'felt' of 'soft' and 'firm', with another block of these.
std::string withBlock(const std::string& conditions, const std::string& order) {
  return tests::withPhases(
      {R"({"id": "more", "type": "block", "minimum_cuts": 1, "conditions": )" + conditions +
       R"(, "order": )" + order + "}"});
}

TEST(Blinding, HoldsWhereOrdersAndLabelsDifferBetweenParticipants) {
  for (const auto* type : {"balancedLatinSquare", "latinSquare", "complete", "random"}) {
    EXPECT_EQ(foundIn(ordered(type)), Words{}) << type;
  }
  EXPECT_EQ(foundIn(tests::with(tests::usualProtocol(), "random", "position")), Words{});
}

TEST(Blinding, IsOpenWhereTheProtocolSaysSo) {
  const auto open = [](const std::string& json) {
    return tests::with(json, R"("languages")", R"("blinding": "open", "languages")");
  };
  EXPECT_EQ(foundIn(open(tests::usualProtocol())), Words{"$.blinding blinding_open"});
  EXPECT_EQ(foundIn(open(ordered("fixed"))), Words{"$.blinding blinding_open"}) << "nothing more";
}

TEST(Blinding, IsBrokenByOneOrderForAll) {
  EXPECT_EQ(foundIn(ordered("fixed")), Words{"$.phases[1].order order_tells"});
}

TEST(Blinding, IsBrokenOnceByAFixedOrderThatIsReversedLater) {
  const auto text = tests::with(
      withBlock(R"(["soft", "firm"])", R"({"type": "reversed", "of": "felt"})"),
      "balancedLatinSquare",
      "fixed");
  EXPECT_EQ(foundIn(text), Words{"$.phases[1].order order_tells"});
}

TEST(Blinding, IsBrokenByLabelsThatStandForConditions) {
  EXPECT_EQ(
      foundIn(
          tests::with(tests::usualProtocol(), R"("policy": "random")", R"("policy": "condition")")),
      Words{"$.labels.policy labels_tell"});
}

TEST(Blinding, IsBrokenByStatementsThatDifferBetweenConditions) {
  const auto text = tests::with(
      tests::with(
          tests::withBenchmark(tests::usualProtocol()), "realism-cuts", "punch-face-validity"),
      R"("questionnaires": [{ "instrument": "punch-face-validity" }])",
      R"("questionnaires": [{"instrument": "punch-face-validity", "set_by_condition":
         {"soft": "1", "firm": "2"}}])");
  EXPECT_EQ(foundIn(text), Words{"$.phases[2].questionnaires[0] statements_tell"});
}

TEST(Blinding, IsBrokenByABlockThatHasSomeOfTheConditionsOnly) {
  EXPECT_EQ(
      foundIn(withBlock(R"(["soft"])", R"({"type": "fixed"})")),
      (Words{"$.conditions[0] blocks_tell", "$.conditions[1] blocks_tell"}));
}

TEST(Blinding, HoldsWhereTheOnlyConditionOfABlockIsComparedWithNone) {
  EXPECT_EQ(foundIn(tests::corpusText("good", "two-devices")), Words{});
}

TEST(Blinding, IsBrokenByASeedThatStandsInTheProtocol) {
  EXPECT_EQ(foundIn(tests::corpusText("good", "seed-of-zero")), Words{"$.seed seed_tells"});
}

}  // namespace blinding_test
}  // namespace protocols
