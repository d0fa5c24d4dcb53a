#include "haptics/bench/machine.h"

#include <sys/utsname.h>

#include <fstream>
#include <thread>

#include "haptics/bench/peers/versions.h"

namespace haptics::bench {
namespace {

std::string firstLineOf(const char* path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "not known";
}

std::string kernel() {
  utsname name{};
  if (uname(&name) != 0) return "not known";
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> machineInWords() {
  const std::string governor = firstLineOf("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  return {
      {"processor",
       processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " in use"},
      {"kernel", kernel()},
      {"frequency governor",
       governor.empty() ? "not told (as in most virtual machines)" : governor},
      {"load (1, 5, 15 min)", firstLineOf("/proc/loadavg").substr(0, 14)},
      {"compiler", std::string("g++ ") + __VERSION__ + ", " + PALPATE_BUILD_FLAGS},
      {"peers", peers::versions()}};
}

}  // namespace haptics::bench
