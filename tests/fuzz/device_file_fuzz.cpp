#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "study/trial/device_file.h"

// Fuzzes the reader of device files: a verdict for everything, words for every refusal, and what it
// takes it takes again when it has been written.

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  const std::string_view text(reinterpret_cast<const char*>(data), count);
  questionnaires::Problems problems;
  const auto devices = study::readDevices(text, problems);
  if (!devices) {
    if (problems.all().empty()) std::abort();
    return 0;
  }
  const auto written = study::devicesAsJson(*devices);
  questionnaires::Problems none;
  const auto again = study::readDevices(written, none);
  if (!again || again->size() != devices->size()) std::abort();
  return 0;
}
