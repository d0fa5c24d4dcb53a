// Commands for the published recordings of a punch, where they have been fetched.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/study/app/palpate_command.h"
#include "tests/support/test_data.h"

namespace real_recording_test {

using nlohmann::json;
using tests::kTheWorldSaidNo;
using tests::palpate;
using tests::Words;

class RealRecording : public tests::StudyOfCommands {};

TEST_F(RealRecording, ImportsARealRecording) {
  constexpr const char* kRecording = "punch/matlab/11_meniscus_fast_1826 - Copy.txt";
  SKIP_WITHOUT_FETCHED_DATA(kRecording);
  const std::string cut = folder_ / "cut.json";
  const auto finished = palpate(
      {"recording", "import", tests::fetchedData(kRecording).string(), "--out", cut, "--json"});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto report = json::parse(finished.out);
  for (const auto* key : {"rows", "sample_rate_hz", "saturated_rows", "max_force_n", "cuts"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  ASSERT_FALSE(report["cuts"].empty());
  for (const auto* key :
       {"first_row",
        "last_row",
        "peak_force_n",
        "interception",
        "yield",
        "bottom_out",
        "opening"}) {
    EXPECT_TRUE(report["cuts"][0].contains(key)) << key;
  }
  EXPECT_TRUE(json::accept(tests::contentOf(cut)));
}

TEST_F(RealRecording, EstimatesTheProcessNoiseOfARecording) {
  constexpr const char* kRecording = "punch/matlab/11_meniscus_fast_1826 - Copy.txt";
  SKIP_WITHOUT_FETCHED_DATA(kRecording);
  const std::string path = tests::fetchedData(kRecording).string();
  const Words call{
      "recording",
      "noise",
      path,
      "--rows",
      "90:170,870:910,1440:1480,2300:2400,3000:3050,3700:3800,4300:4370,5100:5150,5900:5970,"
      "6800:6840",
      "--least-step",
      "0",
      "--filter",
      "authors-fir-333",
      "--json"};
  const auto found = json::parse(palpate(call).out);
  EXPECT_NEAR(found["process_force"].get<double>(), 6.1024, 5e-5);  // eq. (22)
  EXPECT_NEAR(found["process_stiffness"].get<double>(), 7.0275, 5e-5);
  EXPECT_NEAR(found["process_covariance"].get<double>(), 0.2772, 5e-5);
  EXPECT_EQ(palpate({"recording", "noise", path, "--rows", "1:999999"}).status, kTheWorldSaidNo);
}

}  // namespace real_recording_test
