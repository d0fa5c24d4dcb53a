#include "study/app/measurements/packing_report.h"

#include <cmath>

#include <gtest/gtest.h>

namespace study::app {
namespace packing_report_test {

haptics::reaming::BoneFitReport fitWith(double gap, double error) {
  haptics::reaming::BoneFitReport report;
  report.curves.resize(1);
  report.curves[0].curve = "maximum";
  report.curves[0].fit.spheres.gap = gap;
  report.curves[0].fit.spheres.error = error;
  return report;
}

std::string warningOf(double gap, double error) {
  std::string all;
  for (const auto& warning : warningsOf(fitWith(gap, error))) all += warning;
  return all;
}

TEST(PackingReport, WarnsOfACurveThatWasNotFitted) {
  EXPECT_EQ(warningOf(0.005, 0.01), "");
  const auto missed = warningOf(1.0, 0.098);
  EXPECT_NE(missed.find("The maximum curve was not fitted"), std::string::npos) << missed;
  EXPECT_NE(missed.find("100 % above"), std::string::npos) << missed;
  EXPECT_NE(warningOf(std::nan(""), 0.0).find("was not fitted"), std::string::npos);
}

TEST(PackingReport, WarnsOfACurveThatTheSpheresCannotGive) {
  const auto missed = warningOf(1e-9, 0.3);
  EXPECT_NE(missed.find("cannot be felt with these spheres"), std::string::npos) << missed;
  EXPECT_NE(missed.find("30 %"), std::string::npos) << missed;
}

}  // namespace packing_report_test
}  // namespace study::app
