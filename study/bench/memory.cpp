#include "study/bench/memory.h"

#include <fstream>
#include <limits>
#include <string>
#include <string_view>

namespace study::bench {

double peakMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    constexpr std::string_view kMost = "VmHWM:";
    if (line.starts_with(kMost)) return std::stod(line.substr(kMost.size())) * 1024.0 / 1e6;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void resetPeakMemory() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace study::bench
