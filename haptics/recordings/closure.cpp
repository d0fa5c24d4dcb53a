#include "haptics/recordings/closure.h"

#include <algorithm>
#include <iterator>
#include <span>

namespace haptics::recordings {
namespace {

/// Rows from index first to index last, counted from 0.
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
  const auto first = backwards.base();  // one past the smallest, which is its number from 1
  return {
      static_cast<std::size_t>(first - travel.begin()),
      static_cast<std::size_t>(furthest - travel.begin()) + 1};
}

/// From the furthest row of the closing branch to the least travel before @p until.
RowRange openingBranch(
    const std::vector<double>& travel, const RowRange& closing, std::size_t until) {
  const auto first = travel.begin() + static_cast<std::ptrdiff_t>(closing.last) - 1;
  const auto least = std::min_element(first, travel.begin() + static_cast<std::ptrdiff_t>(until));
  return {closing.last, static_cast<std::size_t>(least - travel.begin()) + 1};
}

Closure measured(const Recording& recording, const Trace& trace, const Span& span) {
  constexpr double kSecondsPerMillisecond = 1e-3;
  const std::vector<Recording::Row>& rows = recording.rows;
  Closure closure{.rows = {span.first + 1, span.last + 1}};
  closure.start = rows[span.first].time * kSecondsPerMillisecond;
  const double milliseconds = rows[span.last].time - rows[span.first].time;
  closure.duration = milliseconds * kSecondsPerMillisecond;
  for (std::size_t i = span.first; i <= span.last; ++i) {
    closure.peakForce = std::max(closure.peakForce, trace.force[i]);
    if (rows[i].reading >= kSaturatedReading) ++closure.saturatedRows;
  }
  closure.isComplete =
      span.first > 0 && span.last + 1 < rows.size() && closure.duration <= kLongestClosure;
  return closure;
}

}  // namespace

std::vector<Closure> closuresOf(const Recording& recording, const Trace& trace) {
  std::vector<Closure> closures;
  const std::vector<Span> spans = closedSpans(recording.rows);
  std::size_t from = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Span& span = spans[i];
    Closure closure = measured(recording, trace, span);
    closure.closing = closingBranch(trace.travel, span, from);
    const std::size_t next = i + 1 < spans.size() ? spans[i + 1].first : recording.rows.size();
    closure.opening = openingBranch(trace.travel, closure.closing, next);
    const std::size_t count = next - from;
    closure.landmarks = landmarksAlong(
        std::span(trace.travel).subspan(from, count), std::span(trace.force).subspan(from, count));
    closures.push_back(closure);
    from = span.last;
  }
  return closures;
}

}  // namespace haptics::recordings
