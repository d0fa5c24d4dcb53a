#include "tests/haptics/recordings/made_recording.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/recordings/cut.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/trace.h"

namespace tests {
namespace {

using namespace haptics::recordings;

/// The reading whose force by eq. (1) is nearest, by halving.
double readingOf(double force) {
  double low = 0.0;
  double high = 1023.0;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2.0;
    (forceOf(middle, publishedCalibration()) < force ? low : high) = middle;
  }
  return std::round(low);
}

/// Writes one row after the other.
class Hand {
 public:
  explicit Hand(const MadeRecording& made) : made_(made) {}

  void rest(double travel, int rows) {
    for (int i = 0; i < rows; ++i) write(travel, 0.0);
  }

  void close(double scale) {
    const ForceCurve curve = parametricCut().curve;
    for (int i = 0; i <= kStroke; ++i) {
      const double travel = kEnd * (0.5 - 0.5 * std::cos(std::numbers::pi * i / kStroke));
      write(travel, scale * curve.forceAt(travel));
    }
  }

  void open() {
    for (int i = 0; i <= kStroke; ++i) write(kEnd * (1.0 - static_cast<double>(i) / kStroke), 0.0);
  }

  const std::string& text() const { return text_; }

 private:
  static constexpr int kStroke = 200;
  static constexpr double kEnd = 11.0;  // [travel units]

  void write(double travel, double force) {
    const double r = readingOf(force + made_.bias);
    const double grams = 3e-7 * r * r * r - 3e-4 * r * r + 0.7261 * r;
    const std::string& tab = made_.separator;
    text_ += decimal(r, 0) + tab + decimal(grams, 2) + tab + decimal(452.0 + 3.9 * travel, 2) +
             tab + decimal(travel, 3) + tab + decimal(time_, 2) + tab + made_.lineEnd;
    time_ += 3.0;
  }

  const MadeRecording& made_;
  double time_ = 1000.0;  // [ms]
  std::string text_;
};

}  // namespace

std::string textOf(const MadeRecording& made) {
  Hand hand(made);
  hand.rest(made.beginsClosed ? 9.0 : 0.0, 100);
  for (const double scale : made.scales) {
    hand.close(scale);
    hand.open();
    hand.rest(0.0, 100);
  }
  return hand.text() + made.ending;
}

}  // namespace tests
