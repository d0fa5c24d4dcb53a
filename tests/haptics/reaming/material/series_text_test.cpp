#include <gtest/gtest.h>

#include "haptics/reaming/material/series.h"
#include "haptics/reaming/material/synthetic_series.h"
#include "haptics/recordings/recording.h"
#include "tests/support/complaint.h"
#include "tests/support/says.h"

namespace haptics::reaming {
namespace series_text_test {

using tests::says;

std::string complaintAbout(const std::string& text, const SeriesMapping& mapping = {}) {
  return tests::complaintOf([&] { readSeries(text, "a.csv", mapping); });
}

TEST(SeriesText, IsReadBackUnchanged) {
  const auto series = syntheticSeries({.seed = 2});
  const auto back = readSeries(asText(series), series.name, {});
  EXPECT_NEAR(back.rate, 100.0, 1e-9);
  ASSERT_EQ(back.force.size(), series.force.size());
  EXPECT_EQ(back.force, series.force);
  EXPECT_EQ(back.torque, series.torque);
  for (std::size_t i = 0; i < back.displacement.size(); ++i) {
    ASSERT_NEAR(back.displacement[i], series.displacement[i], 1e-15);
  }
}

TEST(SeriesText, ReadsATableAsAGermanMachineWritesIt) {
  const std::string text =
      "\xef\xbb\xbf"
      "Zeit [ms];Weg [mm];Kraft (kN)\r\n0;0;0,02\r\n10;0,5;0,021\r\n20;1,0;0,0225\r\n";
  const auto series = readSeries(text, "b.csv", {});
  EXPECT_NEAR(series.rate, 100.0, 1e-9);
  EXPECT_EQ(series.force, (std::vector<double>{20.0, 21.0, 22.5}));
  EXPECT_NEAR(series.displacement[1], 0.0005, 1e-15);
  EXPECT_TRUE(series.torque.empty());
}

TEST(SeriesText, UsesAMappingForUnknownHeadings) {
  const std::string text = "a\tb\tc\n0\t0\t1\n0.01\t2\t3\n0.02\t4\t5\n";
  const SeriesMapping mapping{
      .heads = {{"time", "a"}, {"displacement", "b"}, {"force", "c"}},
      .units = {{"time", "s"}, {"displacement", "um"}, {"force", "N"}}};
  const auto series = readSeries(text, "c.tsv", mapping);
  EXPECT_NEAR(series.displacement.back(), 4e-6, 1e-18);
}

TEST(SeriesText, KeepsTheMarkOfSyntheticData) {
  EXPECT_TRUE(readSeries(asText(syntheticSeries({.seed = 2})), "s.csv", {}).isSynthetic);
  const std::string measured = "time_s,displacement_mm,force_n\n0,0,1\n0.01,1,2\n0.02,2,3\n";
  EXPECT_FALSE(readSeries(measured, "m.csv", {}).isSynthetic);
  EXPECT_FALSE(readSeries("# Tuesday, machine 2\n" + measured, "m.csv", {}).isSynthetic);
  EXPECT_TRUE(readSeries("# Tuesday\n# SYNTHETIC\n" + measured, "m.csv", {}).isSynthetic);
  EXPECT_TRUE(says(complaintAbout("# Tuesday\n\n" + measured + "0.03,3,x\n"), "line 7: the force"));
}

TEST(SeriesText, RefusesWhatIsInAnotherUnit) {
  EXPECT_TRUE(says(
      complaintAbout("time_s,displacement_m,force_n\n0,0,1\n1,7.5,3\n2,15.2,3\n"),
      "the displacement goes over 15.200 m"));
  EXPECT_TRUE(says(
      complaintAbout("time_s,displacement_mm,force_kn\n0,0,1\n1,7.5,30\n2,15.2,800\n"),
      "the force goes to 800.0 kN"));
}

TEST(SeriesText, DescribesErrorsInASentence) {
  const std::string head = "time_s,displacement_mm,force_n\n";
  EXPECT_TRUE(says(complaintAbout(head + "0,0,1\n"), "has 1 rows below its head"));
  EXPECT_TRUE(says(complaintAbout(""), "has 0 rows"));
  EXPECT_TRUE(
      says(complaintAbout(head + "0,0,1\n0.01,1,nan\n0.02,2,3\n"), "line 3: the force is 'nan'"));
  EXPECT_TRUE(says(complaintAbout(head + "0,0,1\n0.01,1,\n0.02,2,3\n"), "line 3: the force is ''"));
  EXPECT_TRUE(says(
      complaintAbout(head + "0,0,1\n0.01,1,2\n0.02,2,3\n0.20,3,4\n0.21,4,5\n"),
      "between lines 4 and 5 the time goes on by"));
  EXPECT_TRUE(says(
      complaintAbout("time_s,depth_mm,load\n0,0,1\n1,2,3\n2,3,4\n"),
      "has no column for the force"));
  EXPECT_TRUE(says(
      complaintAbout("time_s,depth_furlongs,force_n\n0,0,1\n1,2,3\n2,3,4\n"),
      "'furlongs' is no unit of displacement"));
  EXPECT_TRUE(says(complaintAbout("time,depth_mm,force_n\n0,0,1\n1,2,3\n2,3,4\n"), "no unit"));
  EXPECT_TRUE(says(complaintAbout(head + "0,0,1\n0,1,2\n0,2,3\n"), "the time does not go on"));
}

}  // namespace series_text_test
}  // namespace haptics::reaming
