#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/devices/device.h"
#include "haptics/timing/monotonic_clock.h"

/// What the tests of every device on a wire ask.
namespace haptics::devices {

/// The time that is @p time from now [ns].
inline std::int64_t soon(std::int64_t time) {
  return timing::now() + time;
}

/// The text of the DeviceError that @p action throws; empty where it throws none.
inline std::string whyNot(const std::function<void()>& action) {
  try {
    action();
  } catch (const DeviceError& error) {
    return error.what();
  }
  return {};
}

inline testing::AssertionResult says(const std::string& text, const std::string& words) {
  if (text.find(words) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << '"' << text << "\" does not say \"" << words << '"';
}
inline testing::AssertionResult says(const base::Message& message, const std::string& words) {
  return says(base::describe(message), words);
}

/// The result of the check that is called @p what; nullptr where there is none.
inline const CheckResult* lineOf(const std::vector<CheckResult>& found, const std::string& what) {
  const auto line = std::find_if(found.begin(), found.end(), [&](const CheckResult& result) {
    return base::describe(result.what) == what;
  });
  return line == found.end() ? nullptr : &*line;
}

}  // namespace haptics::devices
