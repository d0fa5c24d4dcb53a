#include "questionnaires/json/problem.h"

#include <string>

#include <gtest/gtest.h>

namespace questionnaires {
namespace problem_test {

TEST(Problems, AreListedOnePerLine) {
  Problems problems;
  problems.add("$.id", "this is odd", "mend it");
  problems.warn("$", base::Message::verbatim("this is unusual"));
  EXPECT_EQ(
      describe(problems.all()), "error   $.id: this is odd; mend it\nwarning $: this is unusual\n");
}

TEST(Problems, DistinguishErrorsFromWarnings) {
  Problems problems;
  problems.warn("$", base::Message::verbatim("this is unusual"));
  EXPECT_FALSE(problems.hasErrors());
  problems.add("$", "this is odd");
  EXPECT_TRUE(problems.hasErrors());
}

TEST(Problems, AreListedUpToALimit) {
  Problems problems;
  for (std::size_t i = 0; i < 2 * kMostProblems; ++i) problems.add("$", std::to_string(i));
  ASSERT_EQ(problems.all().size(), kMostProblems + 1);
  EXPECT_EQ(base::describe(problems.all().back().what), "there are more problems");
}

TEST(Problems, ForgetNoErrorAmongManyWarnings) {
  Problems problems;
  for (std::size_t i = 0; i < 2 * kMostProblems; ++i)
    problems.warn("$", base::Message::verbatim(std::to_string(i)));
  EXPECT_FALSE(problems.hasErrors());
  problems.add("$", "this is odd");
  EXPECT_TRUE(problems.hasErrors());
  EXPECT_EQ(problems.all().back().severity, Severity::Error);
}

TEST(Problems, CanBeWalkedThroughAtOnce) {
  const auto found = [] {
    Problems problems;
    problems.add("$", "this is odd");
    return problems;
  };
  for (const auto& problem : found().all()) EXPECT_EQ(base::describe(problem.what), "this is odd");
}

}  // namespace problem_test
}  // namespace questionnaires
