#include "haptics/emulators/fri_report.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdio>
#include <string_view>
#include <utility>

namespace haptics::emulators {
namespace {

constexpr std::array<std::string_view, 5> kStates{
    "idle", "monitoring-wait", "monitoring-ready", "commanding-wait", "commanding-active"};
constexpr std::array<std::string_view, 4> kLevels{"poor", "fair", "good", "excellent"};

/// Words in a row.
class Line {
 public:
  void add(std::string_view key, std::string_view value) {
    if (!text_.empty()) text_ += ' ';
    text_.append(key).append("=").append(value);
  }
  template <std::integral Integer>
  void add(std::string_view key, Integer value) {
    add(key, std::string_view(std::to_string(value)));
  }
  void add(std::string_view key, double value) {
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), "%.6g", value);
    add(key, std::string_view(digits.data()));
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

void addAnswers(Line& line, const FriAnswers::Counts& counts) {
  line.add("answered", counts.taken);
  line.add("missed", counts.missed);
  line.add("answers_lost", counts.lost);
  line.add("answers_doubled", counts.doubled);
  line.add("answers_late", counts.late);
  line.add("unasked", counts.unasked);
  line.add("never_sent", counts.neverSent);
  line.add("client_restarts", counts.restarts);
  line.add("undecodable", counts.undecodable);
  line.add("wrong_identifier", counts.wrongIdentifier);
  line.add("wrong_joint_count", counts.wrongJointCount);
  line.add("unexpected_sender", counts.unexpectedSender);
}

void addInjected(Line& line, const FriReport& report) {
  for (std::size_t i = 0; i < kFaultNames.size(); ++i) {
    line.add("injected_" + std::string(kFaultNames[i]), report.injected.of[i]);
  }
  line.add("injected_six_joints", report.sixJoints);
  line.add("injected_nan", report.notANumber);
  line.add("injected_wrong_version", report.wrongVersion);
  line.add("injected_stalled", report.stalled);
  line.add("injected_impostor", report.impostors);
  line.add("misled", report.misled);
}

}  // namespace

std::string statusOf(const FriReport& report) {
  Line line;
  line.add("state", kStates[static_cast<std::size_t>(report.state)]);
  line.add("quality", kLevels[static_cast<std::size_t>(report.quality)]);
  line.add("share", report.connection.share);
  line.add("latency", report.connection.latency);
  line.add("jitter", report.connection.jitter);
  line.add("overlay", std::string_view(report.hasOverlay ? "on" : "off"));
  line.add("force_n", report.force);
  line.add("travel_m", report.travel);
  line.add("zero_at_ns", report.zeroAt);
  line.add("periods", report.periods);
  line.add("late_periods", report.latePeriods);
  line.add("sent", report.messages);
  line.add("datagrams", report.datagrams);
  line.add("unsent", report.unsent);
  addAnswers(line, report.answers);
  addInjected(line, report);
  line.add("end_at_ns", report.endAt);
  line.add("end_joint", report.endJoint);
  line.add("end", "\"" + std::string(nameOf(report.lastEnd)) + "\"");
  return std::move(line).text();
}

}  // namespace haptics::emulators
