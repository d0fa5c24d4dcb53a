#include <limits>

#include <gtest/gtest.h>

#include "haptics/emulators/fri_session.h"

namespace haptics::emulators {
namespace connection_quality_test {

using Level = ConnectionQuality::Level;

struct Row {
  ConnectionQuality::Measures measures;
  Level level;
};

class ConnectionQualityTable : public testing::TestWithParam<Row> {};

TEST_P(ConnectionQualityTable, HasTheDocumentedThresholds) {
  EXPECT_EQ(ConnectionQuality::levelOf(GetParam().measures), GetParam().level);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Rows,
    ConnectionQualityTable,
    testing::Values(
        Row{{1.00, 0.0, 0.0}, Level::Excellent},
        Row{{0.98, 0.5, 0.1}, Level::Excellent},
        Row{{0.97, 0.5, 0.1}, Level::Good},
        Row{{0.98, 0.51, 0.1}, Level::Good},
        Row{{0.98, 0.5, 0.11}, Level::Good},
        Row{{0.90, 0.8, 0.3}, Level::Good},
        Row{{0.89, 0.8, 0.3}, Level::Fair},
        Row{{0.90, 0.81, 0.3}, Level::Fair},
        Row{{0.90, 0.8, 0.31}, Level::Fair},
        Row{{0.70, 1.0, 0.6}, Level::Fair},
        Row{{0.69, 1.0, 0.6}, Level::Poor},
        Row{{1.00, 1.01, 0.0}, Level::Poor},
        Row{{1.00, 0.0, 0.61}, Level::Poor},
        Row{{0.00, 0.0, 0.0}, Level::Poor},
        Row{{kNan, 0.0, 0.0}, Level::Poor},
        Row{{1.00, kNan, 0.0}, Level::Poor},
        Row{{1.00, 0.0, kNan}, Level::Poor}));

void answer(ConnectionQuality& quality, int times, double latency = 0.1) {
  for (int i = 0; i < times; ++i) quality.noteAnswered(latency);
}

void miss(ConnectionQuality& quality, int times) {
  for (int i = 0; i < times; ++i) quality.noteMissed();
}

TEST(ConnectionQuality, StartsPoorUntilAnswersArrive) {
  ConnectionQuality quality;
  EXPECT_EQ(quality.level(), Level::Poor);
  answer(quality, 69);
  EXPECT_EQ(quality.level(), Level::Poor);
  answer(quality, 1);
  EXPECT_EQ(quality.level(), Level::Fair);
  answer(quality, 19);
  EXPECT_EQ(quality.level(), Level::Fair);
  answer(quality, 1);
  EXPECT_EQ(quality.level(), Level::Good);
  answer(quality, 8);
  EXPECT_EQ(quality.level(), Level::Excellent);
}

TEST(ConnectionQuality, FallsWithAnswersThatAreMissed) {
  ConnectionQuality quality;
  answer(quality, 200);
  miss(quality, 2);
  EXPECT_EQ(quality.level(), Level::Excellent);
  miss(quality, 8);
  EXPECT_EQ(quality.level(), Level::Good);
  miss(quality, 1);
  EXPECT_EQ(quality.level(), Level::Fair);
  miss(quality, 20);
  EXPECT_EQ(quality.level(), Level::Poor);
}

TEST(ConnectionQuality, RecoversLongAfterMissedAnswers) {
  ConnectionQuality quality;
  answer(quality, 100);
  miss(quality, 50);
  answer(quality, 100);
  EXPECT_EQ(quality.level(), Level::Excellent);
}

TEST(ConnectionQuality, MeasuresLatencyAndJitter) {
  ConnectionQuality quality;
  for (int i = 0; i < 50; ++i) {
    quality.noteAnswered(0.2);
    quality.noteAnswered(0.4);
  }
  EXPECT_NEAR(quality.measures().share, 1.0, 1e-12);
  EXPECT_NEAR(quality.measures().latency, 0.3, 1e-12);
  EXPECT_NEAR(quality.measures().jitter, 0.2, 1e-12);
  EXPECT_EQ(quality.level(), Level::Good);
}

TEST(ConnectionQuality, IsPoorIfAnswersTakeLongerThanAPeriod) {
  ConnectionQuality quality;
  answer(quality, 100, 1.2);
  EXPECT_EQ(quality.level(), Level::Poor);
}

TEST(ConnectionQuality, ForgetsOnRequest) {
  ConnectionQuality quality;
  answer(quality, 100);
  quality.reset();
  EXPECT_EQ(quality.level(), Level::Poor);
  EXPECT_EQ(quality.measures().share, 0.0);
}

}  // namespace connection_quality_test
}  // namespace haptics::emulators
