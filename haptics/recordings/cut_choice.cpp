#include "haptics/recordings/cut_choice.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "haptics/recordings/error.h"
#include "haptics/recordings/mean_curve.h"

namespace haptics::recordings {
namespace {

std::string named(const std::string& source) {
  return "'" + source + "'";
}

CutChoice chosenRows(const Trace& trace, const RowRange& rows, const std::string& source) {
  const std::size_t count = trace.travel.size();
  const std::string asked = std::to_string(rows.first) + " to " + std::to_string(rows.last);
  if (rows.first < 1 || rows.last > count || rows.first >= rows.last) {
    throw Error(
        "Rows " + asked + " are no part of " + named(source) + ": it has rows 1 to " +
        std::to_string(count) + ", and the first must come before the last.");
  }
  return {{}, {rows}, "rows " + asked + " were asked for"};
}

CutChoice chosenClosures(
    std::span<const Closure> closures,
    const std::vector<std::size_t>& numbers,
    const std::string& source) {
  CutChoice choice{.closures = numbers, .reason = "asked for by number"};
  for (const std::size_t number : numbers) {
    if (number < 1 || number > closures.size()) {
      throw Error(
          "There is no closure " + std::to_string(number) + " in " + named(source) + ": it has " +
          std::to_string(closures.size()) + ", numbered from 1.");
    }
    choice.rows.push_back(closures[number - 1].closing);
  }
  return choice;
}

std::vector<std::size_t> candidates(std::span<const Closure> closures) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < closures.size(); ++i) {
    if (closures[i].isComplete && !closures[i].isSaturated()) numbers.push_back(i + 1);
  }
  return numbers;
}

[[noreturn]] void refuseAll(std::span<const Closure> closures, const std::string& source) {
  const auto isComplete = [](const Closure& closure) { return closure.isComplete; };
  const auto complete = std::ranges::count_if(closures, isComplete);
  if (complete > 0) {
    throw Error(
        "Each of the " + std::to_string(complete) + " complete closures of " + named(source) +
        " has rows where the force sensor was saturated, so that its peak is cut off. Take another "
        "recording, or choose a closure by its number, or rows, if that will do.");
  }
  throw Error(
      "None of the " + std::to_string(closures.size()) + " closures of " + named(source) +
      " is complete (it lies within the recording and lasts at most 4 s): choose one by its "
      "number, "
      "or rows.");
}

CutChoice typicalClosure(
    const Trace& trace, std::span<const Closure> closures, const std::string& source) {
  const std::vector<std::size_t> numbers = candidates(closures);
  if (numbers.empty()) refuseAll(closures, source);
  std::vector<ForceCurve> curves;
  curves.reserve(numbers.size());
  for (const std::size_t number : numbers) {
    curves.push_back(curveOf(trace, closures[number - 1].closing).curve);
  }
  const std::optional<std::size_t> typical = mostTypical(curves);
  if (!typical) {
    throw Error(
        "The closures of " + named(source) +
        " share no travel, so that none is typical: choose one by its number, or rows.");
  }
  CutChoice choice = chosenClosures(closures, {numbers[*typical]}, source);
  const std::string count = std::to_string(numbers.size());
  choice.reason = numbers.size() == 1 ? "the only complete closure without a saturated row"
                                      : "nearest to the mean of the " + count +
                                            " complete closures without a saturated row";
  return choice;
}

void requireOneWish(const ImportOptions& options) {
  if (options.rows && !options.closures.empty()) {
    throw std::invalid_argument("a cut is taken from closures or from rows, not from both");
  }
  std::vector<std::size_t> sorted = options.closures;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end()) {
    throw std::invalid_argument("a closure cannot be taken twice");
  }
}

}  // namespace

CutChoice chooseCut(
    const Trace& trace,
    std::span<const Closure> closures,
    const ImportOptions& options,
    const std::string& source) {
  requireOneWish(options);
  if (options.rows) return chosenRows(trace, *options.rows, source);
  if (closures.empty()) {
    throw Error(
        "There is no closure in " + named(source) +
        ": its travel never rises above 7. Check that the recorder was told both end positions, "
        "or choose rows.");
  }
  if (!options.closures.empty()) return chosenClosures(closures, options.closures, source);
  return typicalClosure(trace, closures, source);
}

}  // namespace haptics::recordings
