#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/recording.h"
#include "tests/haptics/recordings/made_recording.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

// A recording that was damaged is read, or refused in words; it never crashes the importer and
// never puts a number into a curve that is none.

namespace haptics::recordings {
namespace garbage_test {

void expectFinite(const Cut& cut) {
  for (const CurvePoint& node : cut.curve.nodes()) {
    ASSERT_TRUE(std::isfinite(node.travel) && std::isfinite(node.force));
  }
  for (const auto& point :
       {cut.landmarks.interception,
        cut.landmarks.yield,
        cut.landmarks.bottomOut,
        cut.landmarks.opening}) {
    ASSERT_TRUE(!point || (std::isfinite(point->travel) && std::isfinite(point->force)));
  }
}

/// Reads and imports; whether anything came of it.
bool survives(const std::string& text) {
  try {
    const ImportedCut imported = importCut(readRecording(text));
    expectFinite(imported.cut);
    EXPECT_TRUE(std::isfinite(imported.report.survey.sampling.rate));
    EXPECT_LE(imported.cut.curve.largestSlope(), 4.39 * (1.0 + 1e-6));
    return true;
  } catch (const base::UserError& error) {
    EXPECT_GT(std::string(error.what()).size(), 20U);
    return false;
  }
}

std::string flipped(std::string text, std::mt19937& random, int flips) {
  std::uniform_int_distribution<std::size_t> where(0, text.size() - 1);
  std::uniform_int_distribution<int> what(0, 255);
  for (int i = 0; i < flips; ++i) text[where(random)] = static_cast<char>(what(random));
  return text;
}

TEST(Garbage, OfTruncationsIsReadUpToTheirEnd) {
  const std::string whole = tests::textOf({.lineEnd = "\r\\\n", .ending = "}"});
  std::mt19937 random(1826);
  std::uniform_int_distribution<std::size_t> length(0, whole.size());
  int imported = 0;
  for (int i = 0; i < 300; ++i) imported += survives(whole.substr(0, length(random))) ? 1 : 0;
  EXPECT_GT(imported, 100);
  for (std::size_t n = 0; n < 200; ++n) {
    const std::size_t left = whole.size() - n;
    EXPECT_TRUE(survives(whole.substr(0, left))) << n << " bytes cut off";
  }
}

TEST(Garbage, OfFlippedBytesIsReadOrRefused) {
  const std::string whole = tests::textOf({.lineEnd = "\r\n"});
  std::mt19937 random(1842);
  for (int i = 0; i < 400; ++i) survives(flipped(whole, random, 1 + i % 50));
}

TEST(Garbage, OfFlippedDigitsIsReadOrRefused) {
  const std::string whole = tests::textOf({});
  std::mt19937 random(1839);
  std::uniform_int_distribution<std::size_t> where(0, whole.size() - 1);
  const std::string digits = "0123456789.-+eE\t\n";
  std::uniform_int_distribution<std::size_t> what(0, digits.size() - 1);
  for (int i = 0; i < 400; ++i) {
    std::string text = whole;
    for (int k = 0; k < 1 + i % 20; ++k) text[where(random)] = digits[what(random)];
    survives(text);
  }
}

TEST(Garbage, OfNoiseIsRefused) {
  std::mt19937 random(1804);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int i = 0; i < 200; ++i) {
    std::string noise(static_cast<std::size_t>(i * 20), '\0');
    for (char& c : noise) c = static_cast<char>(byte(random));
    EXPECT_FALSE(survives(noise));
  }
}

TEST(Garbage, OfARealRecordingIsReadOrRefused) {
  const char* const kCopy = "punch/matlab/11_meniscus_fast_1826 - Copy.txt";
  SKIP_WITHOUT_FETCHED_DATA(kCopy);
  const std::string whole = tests::contentOf(tests::fetchedData(kCopy));
  std::mt19937 random(1758);
  std::uniform_int_distribution<std::size_t> length(0, whole.size());
  for (int i = 0; i < 40; ++i) survives(whole.substr(0, length(random)));
  for (int i = 0; i < 40; ++i) survives(flipped(whole, random, 1 + i));
}

}  // namespace garbage_test
}  // namespace haptics::recordings
