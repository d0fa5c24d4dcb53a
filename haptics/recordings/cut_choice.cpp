#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/force_curve.h"
#include "haptics/recordings/import_messages.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/trace.h"

namespace haptics::recordings {

namespace {

/// The rows from index `first` to index `last`, both counted from 0.
struct Span {
  std::size_t first = 0;
  std::size_t last = 0;
};

std::vector<Span> closedSpans(const std::vector<Recording::Row>& rows) {
  std::vector<Span> found;
  bool isClosed = false;
  std::size_t start = 0;
  std::size_t lastOpen = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double travel = rows[i].travel;
    if (isClosed && travel < kOpenBelow) {
      found.push_back({start, i});
      isClosed = false;
      lastOpen = i;
    } else if (!isClosed) {
      if (travel <= kOpenBelow) lastOpen = i;
      if (travel > kClosedAbove) {
        isClosed = true;
        start = lastOpen;
      }
    }
  }
  if (isClosed) found.push_back({start, rows.size() - 1});
  return found;
}

RowRange closingBranch(const std::vector<double>& travel, const Span& closed, std::size_t from) {
  const auto at = [&](std::size_t i) { return travel.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto furthest = std::max_element(at(closed.first), at(closed.last + 1));
  const auto backwards = std::min_element(
      std::make_reverse_iterator(furthest + 1), std::make_reverse_iterator(at(from)));
  const auto first = backwards.base();  // one past the smallest, i.e. its number counted from 1
  return {
      static_cast<std::size_t>(first - travel.begin()),
      static_cast<std::size_t>(furthest - travel.begin()) + 1};
}

/// Rows from the end of the closing branch to the smallest travel before @p until.
RowRange openingBranch(
    const std::vector<double>& travel, const RowRange& closing, std::size_t until) {
  const auto first = travel.begin() + static_cast<std::ptrdiff_t>(closing.last) - 1;
  const auto least = std::min_element(first, travel.begin() + static_cast<std::ptrdiff_t>(until));
  return {closing.last, static_cast<std::size_t>(least - travel.begin()) + 1};
}

Closure closureIn(const Recording& recording, const Trace& trace, const Span& span) {
  constexpr double kSecondsPerMillisecond = 1e-3;
  const std::vector<Recording::Row>& rows = recording.rows;
  Closure closure{.rows = {span.first + 1, span.last + 1}};
  closure.start = rows[span.first].time * kSecondsPerMillisecond;
  const double milliseconds = rows[span.last].time - rows[span.first].time;
  closure.duration = milliseconds * kSecondsPerMillisecond;
  for (std::size_t i = span.first; i <= span.last; ++i) {
    closure.peakForce = std::max(closure.peakForce, trace.force[i]);
    if (rows[i].reading >= recording.saturation) ++closure.saturatedRows;
  }
  closure.isComplete =
      span.first > 0 && span.last + 1 < rows.size() && closure.duration <= kLongestClosure;
  return closure;
}

}  // namespace

std::vector<Closure> closuresOf(const Recording& recording, const Trace& trace, double yieldLoad) {
  std::vector<Closure> closures;
  const std::vector<Span> spans = closedSpans(recording.rows);
  std::size_t from = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Span& span = spans[i];
    Closure closure = closureIn(recording, trace, span);
    closure.closing = closingBranch(trace.travel, span, from);
    const std::size_t next = i + 1 < spans.size() ? spans[i + 1].first : recording.rows.size();
    closure.opening = openingBranch(trace.travel, closure.closing, next);
    const std::size_t count = next - from;
    closure.landmarks = landmarksAlong(
        std::span(trace.travel).subspan(from, count),
        std::span(trace.force).subspan(from, count),
        yieldLoad);
    closures.push_back(closure);
    from = span.last;
  }
  return closures;
}

namespace {

std::string sourceName(const std::string& source) {
  return "'" + source + "'";
}

CutChoice chosenRows(const Trace& trace, const RowRange& rows, const std::string& source) {
  const std::size_t count = trace.travel.size();
  const std::string asked = std::to_string(rows.first) + " to " + std::to_string(rows.last);
  if (rows.first < 1 || rows.last > count || rows.first >= rows.last) {
    throw base::UserError(
        "Rows " + asked + " are no part of " + sourceName(source) + ": it has rows 1 to " +
        std::to_string(count) + ", and the first must come before the last.");
  }
  return {{}, {rows}, importMessage("cut_rows_asked_for", rows.first, rows.last)};
}

CutChoice chosenClosures(
    std::span<const Closure> closures,
    const std::vector<std::size_t>& numbers,
    const std::string& source) {
  CutChoice choice{.closures = numbers, .reason = importMessage("cut_asked_for")};
  for (const std::size_t number : numbers) {
    if (number < 1 || number > closures.size()) {
      throw base::UserError(
          "There is no closure " + std::to_string(number) + " in " + sourceName(source) +
          ": it has " + std::to_string(closures.size()) + ", numbered from 1.");
    }
    choice.rows.push_back(closures[number - 1].closing);
  }
  return choice;
}

std::vector<std::size_t> candidateNumbers(std::span<const Closure> closures) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < closures.size(); ++i) {
    if (closures[i].isComplete && !closures[i].isSaturated()) numbers.push_back(i + 1);
  }
  return numbers;
}

[[noreturn]] void refuseAllClosures(std::span<const Closure> closures, const std::string& source) {
  const auto isComplete = [](const Closure& closure) { return closure.isComplete; };
  const auto complete = std::ranges::count_if(closures, isComplete);
  if (complete > 0) {
    throw base::UserError(
        "Each of the " + std::to_string(complete) + " complete closures of " + sourceName(source) +
        " has rows where the force sensor was saturated, so that its peak is cut off. Take another "
        "recording, or choose a closure by its number, or rows, if that will do.");
  }
  throw base::UserError(
      "None of the " + std::to_string(closures.size()) + " closures of " + sourceName(source) +
      " is complete (it lies within the recording and lasts at most 4 s): choose one by its "
      "number, "
      "or rows.");
}

CutChoice typicalClosure(
    const Trace& trace, std::span<const Closure> closures, const std::string& source) {
  const std::vector<std::size_t> numbers = candidateNumbers(closures);
  if (numbers.empty()) refuseAllClosures(closures, source);
  std::vector<ForceCurve> curves;
  curves.reserve(numbers.size());
  for (const std::size_t number : numbers) {
    curves.push_back(curveOf(trace, closures[number - 1].closing).curve);
  }
  const std::optional<std::size_t> typical = indexOfMostTypical(curves);
  if (!typical) {
    throw base::UserError(
        "The closures of " + sourceName(source) +
        " share no travel, so that none is typical: choose one by its number, or rows.");
  }
  CutChoice choice = chosenClosures(closures, {numbers[*typical]}, source);
  choice.reason = numbers.size() == 1 ? importMessage("cut_only_candidate")
                                      : importMessage("cut_most_typical", numbers.size());
  return choice;
}

void requireOneSelection(const ImportOptions& options) {
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
  requireOneSelection(options);
  if (options.rows) return chosenRows(trace, *options.rows, source);
  if (closures.empty()) {
    throw base::UserError(
        "There is no closure in " + sourceName(source) +
        ": its travel never rises above 7. Check that the recorder was told both end positions, "
        "or choose rows.");
  }
  if (!options.closures.empty()) return chosenClosures(closures, options.closures, source);
  return typicalClosure(trace, closures, source);
}

RecordingSurvey summariseCuts(const Recording& recording, const Trace& trace, double yieldLoad) {
  std::vector<double> travels;
  RecordingSurvey survey{.rows = recording.rows.size(), .sampling = samplingOf(recording)};
  for (const Recording::Row& row : recording.rows) {
    if (row.reading >= recording.saturation) ++survey.saturatedRows;
    if (isExtrapolated(row.reading, trace.calibration)) ++survey.uncalibratedRows;
    travels.push_back(row.travel);
  }
  const auto [least, most] = std::ranges::minmax(trace.force);
  survey.minForce = least;
  survey.maxForce = most;

  std::ranges::sort(travels);
  travels.erase(std::unique(travels.begin(), travels.end()), travels.end());
  survey.distinctTravels = travels.size();

  survey.refusedLines = recording.refusedCount;
  survey.closures = closuresOf(recording, trace, yieldLoad);
  return survey;
}

}  // namespace haptics::recordings
