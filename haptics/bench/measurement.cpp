#include "haptics/bench/measurement.h"

#include <sys/utsname.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <thread>

#include "base/text_table.h"
#include "haptics/bench/peers/peers.h"
#include "haptics/filters/averages.h"

namespace haptics::bench {
namespace {

constexpr char kSeparator = '\t';
constexpr const char* kNoValue = "-";

std::string asText(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

std::string asTextOrDash(const std::optional<double>& value) {
  return value ? asText(*value) : kNoValue;
}

std::vector<std::optional<Timing>> optional(const std::vector<Timing>& timings) {
  return {timings.begin(), timings.end()};
}

}  // namespace

std::vector<std::optional<Timing>> AccuracyRun::times(
    const std::vector<Contestant>& contestants) const {
  if (isShortRun) return std::vector<std::optional<Timing>>(contestants.size());
  return optional(timing::compareTimes(contestants));
}

std::vector<std::optional<Timing>> AccuracyRun::coldTimes(
    const std::vector<Contestant>& contestants, int rounds) const {
  if (isShortRun) return std::vector<std::optional<Timing>>(contestants.size());
  return optional(timing::compareColdTimes(contestants, rounds));
}

std::string asLine(const Measurement& m) {
  std::string line = m.family + kSeparator + m.setting + kSeparator + m.method + kSeparator +
                     asText(m.parameter) + kSeparator;
  line += asTextOrDash(m.error) + kSeparator + asTextOrDash(m.bound) + kSeparator;
  line += m.time ? asText(m.time->median) + kSeparator + asText(m.time->p99)
                 : std::string(kNoValue) + kSeparator + kNoValue;
  return line;
}

std::optional<Measurement> fromLine(const std::string& line) {
  constexpr std::size_t kFields = 8;
  const auto fields = base::cellsOf(line, kSeparator);
  if (fields.size() != kFields) return std::nullopt;
  const auto parameter = base::numberFrom<double>(fields[3]);
  if (!parameter) return std::nullopt;
  Measurement m{
      .family = fields[0],
      .setting = fields[1],
      .method = fields[2],
      .parameter = *parameter,
      .error = base::numberFrom<double>(fields[4]),
      .bound = base::numberFrom<double>(fields[5])};
  const auto median = base::numberFrom<double>(fields[6]);
  const auto p99 = base::numberFrom<double>(fields[7]);
  if (median && p99) m.time = Timing{*median, *p99};
  return m;
}

std::vector<RepeatedMeasurement> mergedOverProcesses(const std::vector<Measurement>& measurements) {
  struct Times {
    std::vector<double> medians;
    std::vector<double> p99s;
  };
  std::map<std::string, std::size_t> places;
  std::vector<RepeatedMeasurement> all;
  std::vector<Times> times;
  for (const auto& m : measurements) {
    const std::string key = m.family + kSeparator + m.setting + kSeparator + m.method + kSeparator +
                            asText(m.parameter);
    const auto [place, isNew] = places.emplace(key, all.size());
    if (isNew) {
      all.push_back({.measurement = m});
      times.emplace_back();
    }
    ++all[place->second].processes;
    if (!m.time) continue;
    times[place->second].medians.push_back(m.time->median);
    times[place->second].p99s.push_back(m.time->p99);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& medians = times[i].medians;
    if (medians.empty()) continue;
    all[i].measurement.time =
        Timing{filters::upperMedian(medians), filters::upperMedian(times[i].p99s)};
    all[i].fastest = *std::ranges::min_element(medians);
    all[i].slowest = *std::ranges::max_element(medians);
  }
  return all;
}

namespace {

std::string firstLineOf(const char* path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "not known";
}

std::string kernelVersion() {
  utsname name{};
  if (uname(&name) != 0) return "not known";
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> describeMachine() {
  const std::string governor = firstLineOf("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  return {
      {"processor",
       processorName() + ", " + std::to_string(std::thread::hardware_concurrency()) + " in use"},
      {"kernel", kernelVersion()},
      {"frequency governor",
       governor.empty() ? "not told (as in most virtual machines)" : governor},
      {"load (1, 5, 15 min)", firstLineOf("/proc/loadavg").substr(0, 14)},
      {"compiler", std::string("g++ ") + __VERSION__ + ", " + PALPATE_BUILD_FLAGS},
      {"peers", peers::versions()}};
}

}  // namespace haptics::bench
