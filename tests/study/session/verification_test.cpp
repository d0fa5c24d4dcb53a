#include "study/session/verification.h"

#include <gtest/gtest.h>

#include "study/cohort/simulated_participant.h"
#include "tests/study/made_study.h"

namespace study {
namespace verification_test {

std::string problemsIn(const Verification& verification) {
  std::string text;
  for (const auto& check : verification.checks) {
    for (const auto& problem : check.problems) text += check.what + ": " + problem + "\n";
  }
  return text;
}

/// Simulated participants take part from the first check to the last.
TEST(Verification, IsSoundWhileOthersTakePart) {
  constexpr int kMost = 8;
  tests::MadeStudy study;
  SimulatedClock clock;
  auto station = Study::open(study.folder(), clock);
  int people = 0;
  const auto takePart = [&](double, const std::string&) {
    if (people < kMost) simulateCohorts(station, clock, ++people, 1, [](const auto&) {});
  };
  takePart(0.0, {});
  EXPECT_EQ(problemsIn(verify(*study, takePart)), "");
  EXPECT_EQ(people, kMost);
  EXPECT_EQ(problemsIn(verify(*study)), "");
  // Nothing of it is left open: the study can be written.
  EXPECT_NO_THROW(Session::enrol(*study, {.cohort = "surgeons"}));
}

}  // namespace verification_test
}  // namespace study
