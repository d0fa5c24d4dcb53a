#pragma once

#include <string>
#include <vector>

namespace tests {

/// A recording made up for a test: a hand that rests open, closes, presses, opens, as often as
/// there are scales. While it closes it feels parametricCut() times that scale, and while it opens
/// nothing.
struct MadeRecording {
  std::vector<double> scales{0.8, 1.0, 1.3};
  double bias = 0.0;           ///< added to every force [N]
  std::string lineEnd = "\n";  ///< also "\r\n" and "\r\\\n"
  std::string separator = "\t";
  std::string ending{};       ///< after the last row, e.g. "}"
  bool beginsClosed = false;  ///< the first rest is a closed one
};

/// The rows as text: reading, grams, potentiometer, travel, time, every 3 ms from 1000 ms on.
std::string textOf(const MadeRecording& made);

}  // namespace tests
