#include "haptics/emulators/fri_fault_queue.h"

#include <charconv>
#include <system_error>

#include "base/text_table.h"

namespace haptics::emulators {
namespace {

constexpr int kLargestNumber = 1'000'000;

/// Parses a number from 1 to kLargestNumber.
std::optional<int> numberFrom(std::string_view text) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool isNumber =
      error == std::errc{} && stop == end && number >= 1 && number <= kLargestNumber;
  return isNumber ? std::optional(number) : std::nullopt;
}

constexpr std::string_view kQualityLevels = "poor|good";  // as arguments, these are 1 and 2

std::optional<int> argumentFrom(std::string_view text, std::string_view usage) {
  if (usage != kQualityLevels) return numberFrom(text);
  if (text == "poor") return 1;
  return text == "good" ? std::optional(2) : std::nullopt;
}

std::uint32_t bitOf(FriFaultQueue::Event event) noexcept {
  return 1U << static_cast<unsigned>(event);
}

}  // namespace

struct FriFaultQueue::Command {
  std::string_view name;
  std::string_view usage;
  std::size_t arguments;
  void (*execute)(FriFaultQueue& queue, int first, int second);
};

const FriFaultQueue::Command FriFaultQueue::kCommands[] = {
    {"drop", "N", 1, [](auto& o, int n, int) { o.impairment_.schedule(Fault::Drop, n); }},
    {"double", "N", 1, [](auto& o, int n, int) { o.impairment_.schedule(Fault::Double, n); }},
    {"reorder", "N", 1, [](auto& o, int n, int) { o.impairment_.schedule(Fault::Reorder, n); }},
    {"delay",
     "N MS",
     2,
     [](auto& o, int n, int ms) {
       o.impairment_.setDelay(o.periodsOf(ms));
       o.impairment_.schedule(Fault::Delay, n);
     }},
    {"garbage", "N", 1, [](auto& o, int n, int) { o.impairment_.schedule(Fault::Garbage, n); }},
    {"damage", "N", 1, [](auto& o, int n, int) { o.impairment_.schedule(Fault::Damage, n); }},
    {"stall", "MS", 1, [](auto& o, int ms, int) { o.add(OneTimeFault::Stall, o.periodsOf(ms)); }},
    {"six-joints", "N", 1, [](auto& o, int n, int) { o.add(OneTimeFault::SixJoints, n); }},
    {"nan", "N", 1, [](auto& o, int n, int) { o.add(OneTimeFault::NotANumber, n); }},
    {"impostor", "N", 1, [](auto& o, int n, int) { o.add(OneTimeFault::Impostor, n); }},
    {"quality",
     kQualityLevels,
     1,
     [](auto& o, int level, int) {
       o.isQualityPoor_.store(level == 1, std::memory_order_relaxed);
     }},
    {"wrong-version", "", 0, [](auto& o, int, int) { o.raise(Event::WrongVersion); }},
    {"safety-stop", "", 0, [](auto& o, int, int) { o.raise(Event::SafetyStop); }},
    {"safety-reset", "", 0, [](auto& o, int, int) { o.raise(Event::SafetyReset); }},
    {"motion", "", 0, [](auto& o, int, int) { o.raise(Event::Motion); }},
    {"restart", "", 0, [](auto& o, int, int) { o.raise(Event::Restart); }},
    {"idle", "", 0, [](auto& o, int, int) { o.raise(Event::Idle); }}};

std::optional<std::string> FriFaultQueue::executeLine(std::string_view line) {
  const auto words = base::splitText(line, " \t\r\n");
  if (words.empty()) return "There is no word in this line.";
  for (const Command& command : kCommands) {
    if (command.name == words.front()) return execute(command, line, std::span(words).subspan(1));
  }
  return "'" + std::string(line) + "' is no command. There are: " + help();
}

std::string FriFaultQueue::help() {
  std::string known;
  for (const Command& command : kCommands) {
    known += std::string(command.name) + (command.usage.empty() ? "" : " ") +
             std::string(command.usage) + ", ";
  }
  return known + "status, help, quit; N and MS are whole numbers from 1 to 1000000";
}

std::optional<std::string> FriFaultQueue::execute(
    const Command& command, std::string_view line, std::span<const std::string_view> texts) {
  std::array<int, 2> arguments{};
  bool isUnderstood = texts.size() == command.arguments;
  for (std::size_t i = 0; isUnderstood && i < command.arguments; ++i) {
    const auto argument = argumentFrom(texts[i], command.usage);
    isUnderstood = argument.has_value();
    arguments[i] = argument.value_or(0);
  }
  if (!isUnderstood) {
    const std::string form =
        std::string(command.name) + (command.usage.empty() ? "" : " ") + std::string(command.usage);
    return "'" + std::string(line) + "': the command is \"" + form + "\"" +
           (command.arguments == 0 || command.usage == kQualityLevels
                ? ""
                : "; N and MS are whole numbers from 1 to 1000000");
  }
  command.execute(*this, arguments[0], arguments[1]);
  return std::nullopt;
}

void FriFaultQueue::add(OneTimeFault fault, int howMany) noexcept {
  pendingOneTime_[static_cast<std::size_t>(fault)].fetch_add(howMany, std::memory_order_relaxed);
}

bool FriFaultQueue::take(OneTimeFault fault) noexcept {
  auto& left = pendingOneTime_[static_cast<std::size_t>(fault)];
  if (left.load(std::memory_order_relaxed) <= 0) return false;
  left.fetch_sub(1, std::memory_order_relaxed);  // no race: only one thread takes
  return true;
}

void FriFaultQueue::raise(Event event) noexcept {
  events_.fetch_or(bitOf(event), std::memory_order_relaxed);
}

bool FriFaultQueue::take(Event event) noexcept {
  const std::uint32_t bit = bitOf(event);
  if ((events_.load(std::memory_order_relaxed) & bit) == 0) return false;
  events_.fetch_and(~bit, std::memory_order_relaxed);
  return true;
}

int FriFaultQueue::periodsOf(int milliseconds) const noexcept {
  return (milliseconds + period_ - 1) / period_;
}

}  // namespace haptics::emulators
