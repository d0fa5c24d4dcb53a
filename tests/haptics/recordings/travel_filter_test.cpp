#include "haptics/recordings/travel_filter.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/filters/low_pass.h"
#include "haptics/recordings/recording.h"
#include "tests/support/complaint.h"
#include "tests/support/test_data.h"

namespace haptics::recordings {
namespace travel_filter_test {

using Kind = TravelFilter::Kind;

/// The amplitude that a filter leaves of a sine of amplitude 1, far from its ends.
double gainAt(const TravelFilter& filter, double rate, double frequency) {
  const auto count = static_cast<std::size_t>(8.0 * rate);
  std::vector<double> travel;
  for (std::size_t i = 0; i < count; ++i) {
    travel.push_back(std::cos(2.0 * std::numbers::pi * frequency * static_cast<double>(i) / rate));
  }
  const auto smooth = filtered(travel, rate, filter);
  // Least squares over the middle: a phase would show as a smaller gain.
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = count / 4; i < 3 * count / 4; ++i) {
    product += smooth[i] * travel[i];
    square += travel[i] * travel[i];
  }
  return product / square;
}

std::string complaintAbout(double rate, const TravelFilter& filter) {
  const std::vector<double> travel(1000, 1.0);
  return tests::complaintOf([&] { filtered(travel, rate, filter); });
}

TEST(AuthorsFir, HalvesTheSameFrequencyAtEveryRate) {
  for (const double rate : {100.0, 308.0, 1000.0 / 3.0, 373.0, 1000.0, 4000.0}) {
    EXPECT_NEAR(gainAt({}, rate, 17.69075), 0.5, 2e-3) << rate;
    EXPECT_NEAR(gainAt({}, rate, 5.0), 1.0, 2e-3) << rate;  // MATLAB's edge of the pass-band
    EXPECT_NEAR(gainAt({}, rate, 35.0), 0.0, 2e-3) << rate;
  }
}

TEST(AuthorsFir, HasTheAuthorsTapsAtTheirRate) {
  std::vector<double> travel;
  for (int i = 0; i < 400; ++i) travel.push_back(std::floor(0.02 * i) + 0.3 * (i % 7));
  EXPECT_EQ(
      filtered(travel, 1000.0 / 3.0, {}), filtered(travel, 500.0, {.kind = Kind::AuthorsFir333}));
}

TEST(AuthorsFir333, CountsRowsAndHalvesAnotherFrequencyAtAnotherRate) {
  const TravelFilter counting{.kind = Kind::AuthorsFir333};
  EXPECT_NEAR(gainAt(counting, 1000.0, 3.0 * 17.69075), 0.5, 2e-3);
  EXPECT_NEAR(gainAt(counting, 1000.0, 17.69075), 0.99738, 1e-4);  // SciPy: firwin, freqz
}

TEST(AuthorsFir, IsRefusedWhereTheRateIsTooLowOrThereIsNone) {
  EXPECT_NE(complaintAbout(35.0, {}).find("17.69 Hz needs more than 35.38"), std::string::npos);
  EXPECT_NE(complaintAbout(0.0, {}).find("has no rate"), std::string::npos);
  EXPECT_NE(complaintAbout(1e6, {}).find("every tenth row"), std::string::npos);
}

TEST(ButterworthZeroPhase, HasTheGainsOfSciPy) {
  std::ifstream file(tests::testData("recordings/golden.json"));
  const auto golden = nlohmann::json::parse(file)["butterworth"];
  ASSERT_EQ(golden.size(), 3U);
  for (const auto& row : golden) {
    const double rate = row["rate_hz"].get<double>();
    const TravelFilter filter{
        .kind = Kind::ButterworthZeroPhase, .cutoff = row["cutoff_hz"].get<double>()};
    for (std::size_t i = 0; i < row["gains"].size(); ++i) {
      const double frequency = row["frequencies_hz"][i].get<double>();
      EXPECT_NEAR(gainAt(filter, rate, frequency), row["gains"][i].get<double>(), 2e-5)
          << rate << " " << frequency;
    }
  }
}

TEST(ButterworthZeroPhase, FiltersAStrokeAsSciPyDoes) {
  std::ifstream file(tests::testData("recordings/golden.json"));
  const auto golden = nlohmann::json::parse(file)["butterworth"];
  for (const auto& row : golden) {
    const double rate = row["rate_hz"].get<double>();
    std::vector<double> travel;
    for (std::size_t i = 0; i < row["samples"].get<std::size_t>(); ++i) {
      const double t = static_cast<double>(i) / rate;
      const auto wave = [&](double f) { return std::sin(2.0 * std::numbers::pi * f * t); };
      travel.push_back(
          10.0 * wave(0.2) * wave(0.2) + 0.5 * wave(3.0) + 0.3 * wave(8.0) + 0.1 * wave(50.0));
    }
    const auto smooth = filtered(
        travel,
        rate,
        {.kind = Kind::ButterworthZeroPhase, .cutoff = row["cutoff_hz"].get<double>()});
    ASSERT_GE(row["places"].size(), 10U);
    for (std::size_t i = 0; i < row["places"].size(); ++i) {
      const auto place = row["places"][i].get<std::size_t>();
      EXPECT_NEAR(smooth[place], row["filtered"][i].get<double>(), 1e-8) << rate << " " << place;
    }
  }
}

TEST(ButterworthZeroPhase, IsRefusedWhereTheRateIsTooLow) {
  const TravelFilter filter{.kind = Kind::ButterworthZeroPhase, .cutoff = 50.0};
  EXPECT_NE(
      complaintAbout(100.0, filter).find("50.00 Hz needs more than 100.00"), std::string::npos);
  EXPECT_EQ(complaintAbout(101.0, filter), "");
}

TEST(TravelFilter, LeavesTheTravelAloneWhereAskedTo) {
  const std::vector<double> travel{0.25, 0.51, 0.25, 1.02};
  EXPECT_EQ(filtered(travel, 0.0, {.kind = Kind::None}), travel);
}

TEST(TravelFilter, IsFoundByItsName) {
  for (const auto kind :
       {Kind::AuthorsFir, Kind::AuthorsFir333, Kind::ButterworthZeroPhase, Kind::None}) {
    EXPECT_EQ(travelFilterNamed(nameOf(kind)), kind);
  }
  EXPECT_EQ(travelFilterNames().size(), 4U);
  EXPECT_FALSE(travelFilterNamed("butterworth"));
}

TEST(TravelFilter, StatesEveryParameterThatItUses) {
  const auto mentions = [](const TravelFilter& filter, double rate, const std::string& words) {
    const std::string text = parametersOf(filter, rate);
    EXPECT_NE(text.find(words), std::string::npos) << text << " does not mention " << words;
  };
  mentions({}, 1000.0, "145-tap");
  mentions({}, 1000.0, "-6 dB at 17.69075 Hz");
  mentions({}, 1000.0, "own 1000.0 Hz");
  mentions({}, 1000.0, "beta 5.653");
  mentions({.kind = Kind::AuthorsFir333}, 1000.0, "49-tap");
  mentions({.kind = Kind::AuthorsFir333}, 1000.0, "really -6 dB at 53.07 Hz");
  mentions({.kind = Kind::ButterworthZeroPhase}, 1000.0, "-6 dB at 5.000 Hz");
  // SciPy: brentq of |freqz(butter(4, 5, fs=1000))|² − 1/√2
  mentions({.kind = Kind::ButterworthZeroPhase}, 1000.0, "-3 dB at 4.478 Hz");
}

}  // namespace travel_filter_test
}  // namespace haptics::recordings
