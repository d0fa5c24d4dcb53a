// Every person shares the released values with at least k − 1 others.
#include "study/export/k_anonymity.h"

#include <map>
#include <numeric>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "study/export/coarsening.h"

namespace study {
namespace k_anonymity_test {

QuasiIdentifier asIs(const std::string& name, const Values& values) {
  return {.name = name, .exact = values, .levels = {values}};
}

/// The smallest class, counted independently of the program.
std::size_t smallestClass(const Release& release, std::size_t people) {
  std::map<std::string, std::size_t> classes;
  for (std::size_t person = 0; person < people; ++person) {
    std::string said;
    for (const auto& column : release.columns) said += column.values[person] + '\x1f';
    ++classes[said];
  }
  std::size_t smallest = people;
  for (const auto& [said, count] : classes) smallest = std::min(smallest, count);
  return smallest;
}

/// People with random values.
std::vector<QuasiIdentifier> someCohort(std::mt19937& random, std::size_t people) {
  std::vector<QuasiIdentifier> identifiers;
  const int respects = 1 + static_cast<int>(random() % 5);
  for (int i = 0; i < respects; ++i) {
    const std::size_t variety = 1 + random() % 12;
    QuasiIdentifier identifier{.name = "q" + std::to_string(i), .exact = {}, .levels = {}};
    for (std::size_t person = 0; person < people; ++person) {
      const std::size_t value = random() % variety;
      identifier.exact.push_back(value == 0 ? "" : std::to_string(value));
    }
    for (std::size_t width = 1; width <= variety; width *= 2) {
      auto& level = identifier.levels.emplace_back();
      for (const auto& exact : identifier.exact) {
        level.push_back(exact.empty() ? "" : "b" + std::to_string(std::stoul(exact) / width));
      }
    }
    identifiers.push_back(std::move(identifier));
  }
  return identifiers;
}

TEST(KAnonymity, HoldsForRandomParticipants) {
  std::mt19937 random(20261121);
  std::size_t toldCells = 0;
  for (int study = 0; study < 2000; ++study) {
    const std::size_t people = 5 + random() % 60;
    const std::size_t k = 5 + random() % 3;
    const auto release = computeRelease(someCohort(random, people), people, k);
    ASSERT_EQ(release.has_value(), people >= k);
    if (!release) continue;
    EXPECT_GE(smallestClass(*release, people), k);
    EXPECT_EQ(release->after.smallest, smallestClass(*release, people));
    EXPECT_EQ(release->after.peopleInSmallClasses, 0U);
    for (const auto& column : release->columns) toldCells += column.level ? people : 0;
  }
  EXPECT_GT(toldCells, 10'000U);  // releasing nothing would pass the test
}

TEST(KAnonymity, IsDeterministic) {
  std::mt19937 random(7);
  const auto people = someCohort(random, 40);
  const auto first = computeRelease(people, 40, 5);
  const auto second = computeRelease(people, 40, 5);
  for (std::size_t i = 0; i < first->columns.size(); ++i) {
    EXPECT_EQ(first->columns[i].values, second->columns[i].values);
  }
}

TEST(KAnonymity, ReleasesEverythingIfAllClassesAreLargeEnough) {
  const Values cohort{"a", "a", "a", "a", "a", "b", "b", "b", "b", "b"};
  const auto release =
      computeRelease({asIs("cohort", cohort), asIs("one", Values(10, "x"))}, 10, 5);
  EXPECT_EQ(release->columns[0].values, cohort);
  EXPECT_EQ(release->columns[1].values, Values(10, "x"));
  EXPECT_EQ(release->before.smallest, 5U);
}

TEST(KAnonymity, PrefersTheFirstQuasiIdentifiers) {
  const Values cohort{"a", "a", "a", "a", "a", "b", "b", "b", "b", "b"};
  const Values hand{"r", "l", "r", "l", "r", "l", "r", "l", "r", "l"};
  const auto release = computeRelease({asIs("cohort", cohort), asIs("hand", hand)}, 10, 5);
  EXPECT_TRUE(release->columns[0].level.has_value());
  EXPECT_FALSE(release->columns[1].level.has_value());
  EXPECT_EQ(release->columns[1].values, Values(10, ""));
}

TEST(KAnonymity, SuppressesRareValuesAndKeepsTheSuppressedClassLargeEnough) {
  EXPECT_EQ(suppressRareValues({"a", "a", "a", "b"}, 2), Values(4, ""));
  EXPECT_EQ(
      suppressRareValues({"a", "a", "a", "b", "c", "d", "d"}, 2),
      (Values{"a", "a", "a", "", "", "d", "d"}));
  EXPECT_EQ(
      suppressRareValues({"", "a", "a", "b", "b", "b"}, 2), (Values{"", "", "", "b", "b", "b"}));
}

TEST(KAnonymity, ListsTheCausesOfSmallClasses) {
  const Values age{"30", "31", "32", "33", "34", "35"};
  const Values hand{"r", "r", "r", "r", "r", "l"};
  const auto release = computeRelease({asIs("hand", hand), asIs("age", age)}, 6, 5);
  ASSERT_EQ(release->before.causes.size(), 2U);
  EXPECT_EQ(release->before.causes[0], (std::pair<std::string, std::size_t>{"age", 6}));
  EXPECT_EQ(release->before.causes[1], (std::pair<std::string, std::size_t>{"hand", 1}));
  EXPECT_EQ(release->before.smallest, 1U);
  EXPECT_EQ(release->after.smallest, 6U);
}

TEST(KAnonymity, RefusesTooFewPeople) {
  EXPECT_FALSE(computeRelease({asIs("hand", Values(4, "r"))}, 4, 5));
  EXPECT_THROW(computeRelease({asIs("hand", Values(4, "r"))}, 4, 1), std::invalid_argument);
  EXPECT_THROW(computeRelease({asIs("hand", Values(4, "r"))}, 6, 5), std::invalid_argument);
}

questionnaires::Item years() {
  questionnaires::Item item;
  item.type = questionnaires::ItemType::Number;
  item.least = 0;
  item.most = 70;
  item.step = 1;
  return item;
}

TEST(GeneralisationHierarchy, NeverReleasesAnExactAge) {
  const GeneralisationHierarchy coarsening(years(), "en");
  ASSERT_EQ(coarsening.levelCount(), 4U);
  EXPECT_EQ(coarsening.releasedValue(0, 37.0), "35 to 39");
  EXPECT_EQ(coarsening.releasedValue(1, 37.0), "30 to 39");
  EXPECT_EQ(coarsening.releasedValue(2, 37.0), "20 to 39");
  EXPECT_EQ(coarsening.releasedValue(3, 37.0), "0 to 39");
  EXPECT_EQ(coarsening.releasedValue(0, 0.0), "0 to 4");
  EXPECT_EQ(coarsening.releasedValue(0, 70.0), "70 to 74");
  EXPECT_EQ(coarsening.values(0).size(), 15U);
}

TEST(GeneralisationHierarchy, ReleasesFractionsAsHalfOpenBands) {
  auto item = years();
  item.step = 0.1;
  EXPECT_EQ(GeneralisationHierarchy(item, "en").releasedValue(0, 4.9), "0 to <5");
  item.most = 2.0;
  EXPECT_EQ(GeneralisationHierarchy(item, "en").releasedValue(0, 1.3), "1 to <1.5");
}

TEST(GeneralisationHierarchy, JoinsNeighbouringBandsAndLeavesOtherOptionsAlone) {
  questionnaires::Item item;
  item.type = questionnaires::ItemType::SingleChoice;
  for (const auto* id : {"none", "1-9", "10-59", "60-plus", "no-answer"}) {
    const std::map<std::string, std::string> text{{"en", id}};
    item.options.push_back({id, questionnaires::LocalizedText(text)});
  }
  const GeneralisationHierarchy coarsening(item, "en");
  ASSERT_EQ(coarsening.levelCount(), 3U);
  EXPECT_EQ(coarsening.releasedValue(0, std::string("10-59")), "10-59");
  EXPECT_EQ(coarsening.releasedValue(1, std::string("10-59")), "1-9 to 10-59");
  EXPECT_EQ(coarsening.releasedValue(1, std::string("60-plus")), "60-plus");
  EXPECT_EQ(coarsening.releasedValue(2, std::string("1-9")), "1-9 to 60-plus");
  EXPECT_EQ(coarsening.releasedValue(2, std::string("none")), "none");
  EXPECT_EQ(coarsening.releasedValue(0, std::string("of old")), "");
}

}  // namespace k_anonymity_test
}  // namespace study
