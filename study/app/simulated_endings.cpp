#include "study/app/simulated_endings.h"

#include <algorithm>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "study/words/counted.h"

namespace study::app {
namespace {

bool isCompleted(const SimulatedSessionResult& ending) noexcept {
  return ending.state == SessionState::Completed;
}

/// The reason without the full stop at its end.
std::string_view phraseOf(const SimulatedSessionResult& ending) noexcept {
  std::string_view reason = ending.reason;
  while (reason.ends_with('.')) reason.remove_suffix(1);
  return reason;
}

}  // namespace

int countCompleted(const std::vector<SimulatedSessionResult>& endings) noexcept {
  return static_cast<int>(std::ranges::count_if(endings, isCompleted));
}

std::string describe(const SimulatedSessionResult& ending) {
  std::string text = fmt::format(
      "{} ended as {} at step {} after {}",
      ending.participant,
      nameOf(ending.state),
      ending.step,
      words::counted(static_cast<std::uint64_t>(ending.attempts), "attempt"));
  if (!ending.reason.empty()) text += fmt::format(": {}", phraseOf(ending));
  text += ".";
  if (ending.trials > 0) {
    text += fmt::format(" Trials finished: {} of {}.", ending.trialsFinished, ending.trials);
  }
  return text;
}

std::string describeIncomplete(const std::vector<SimulatedSessionResult>& endings) {
  std::map<SessionState, std::pair<int, std::string>> others;
  for (const auto& ending : endings) {
    if (isCompleted(ending)) continue;
    auto& [count, who] = others[ending.state];
    constexpr int kMostListed = 5;
    if (++count <= kMostListed) {
      who += fmt::format("{}{} at step {}", count > 1 ? "; " : "", ending.participant, ending.step);
      if (!ending.reason.empty()) who += fmt::format(": {}", phraseOf(ending));
    } else if (count == kMostListed + 1) {
      who += "; …";
    }
  }
  std::string text;
  for (const auto& [state, told] : others) {
    text += fmt::format(", {} ended as {} ({})", told.first, nameOf(state), told.second);
  }
  return text;
}

}  // namespace study::app
