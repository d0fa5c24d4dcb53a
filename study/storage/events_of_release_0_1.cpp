#include "study/storage/events_of_release_0_1.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <regex>

#include "study/model/messages.h"
#include "study/storage/answer_repository.h"
#include "study/storage/protocol_repository.h"

namespace study::storage::release_0_1 {
namespace {

constexpr std::string_view kKeptApart = " (kept apart)";
constexpr std::size_t kLongestText = 200;

/// A sentence with which release 0.1 described a trial: its message key, a regular expression, and
/// the type of each argument: an integer (i), another number (d), a text (t).
struct Sentence {
  std::string_view key;
  const char* pattern;
  std::string_view arguments;
};

constexpr const char* kTimes = R"( \((\d+)×, ([\d.]+) s\))";

constexpr std::array kSentences{
    Sentence{"trial.broke_off", R"(the trial broke off \((\w+)\))", "t"},
    Sentence{"trial.broke_off.fault", R"(the trial broke off \((\w+): (.*?)\)(?=; |$))", "tt"},
    Sentence{"trial.samples_kept", R"((\d+) of (\d+) samples were kept)", "ii"},
    Sentence{"trial.samples_lost.one", R"((\d+) sample was lost)", "i"},
    Sentence{"trial.samples_lost", R"((\d+) samples were lost)", "i"},
    Sentence{"trial.device_silent", R"(the device was silent for (\d+) ticks)", "i"},
    Sentence{"trial.device_silent.one", R"(the device was silent for (\d+) tick)", "i"},
    Sentence{
        "trial.wire_faults",
        R"(on the device's wire (\d+) were lost, (\d+) doubled, (\d+) late, (\d+) damaged, (\d+) foreign)",
        "iiiii"},
    Sentence{"trial.clipped", R"(the device gave less than it was asked for in (\d+) ticks)", "i"},
    Sentence{
        "trial.clipped.one", R"(the device gave less than it was asked for in (\d+) tick)", "i"},
    Sentence{"trial.rate", R"(([\d.]+) of ([\d.]+) Hz were reached)", "dd"},
    Sentence{
        "trial.late.machine",
        R"((\d+) of (\d+) ticks were late, (\d+) of them because the machine itself stood still)",
        "iii"},
    Sentence{"trial.late", R"((\d+) of (\d+) ticks were late)", "ii"},
    Sentence{"trial.cut_off", R"(the force was cut off for ([\d.]+) s of ([\d.]+) s)", "dd"},
    Sentence{"trial.no_force", R"(the scene had no force for ([\d.]+) s)", "d"},
    Sentence{
        "trial.damping",
        R"(passivity \(b > KT/2\) needs ([\d.e+-]+) N·s/(\w+) of damping, the device has ([\d.e+-]+), the rest is the hand's)",
        "dtd"},
    Sentence{"trial.too_fast", "the tool was too fast, and the force faded", "id"},
    Sentence{"trial.released", "the dead-man switch was released", "id"},
    Sentence{"trial.lost_beats", "the loop lost beats, and the force faded", "id"},
    Sentence{"trial.not_finite", "the scene asked for a force that is no number", "id"},
    Sentence{
        "trial.active", "the scene gave more energy than it was given: it may have vibrated", "id"},
    Sentence{
        "trial.soft_start",
        "the force never came on: the scene asked for too much all along",
        "id"},
};

std::string shortest(double value) {
  std::array<char, 40> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::regex patternOf(const Sentence& sentence) {
  std::string pattern = sentence.pattern;
  if (pattern.find('(') == std::string::npos) pattern += kTimes;
  return std::regex(pattern + "(; |$)");
}

base::Argument argumentOf(char kind, const std::string& text) {
  if (kind == 't') return text;
  if (kind == 'd') return std::strtod(text.c_str(), nullptr);
  return static_cast<std::int64_t>(std::strtoll(text.c_str(), nullptr, 10));
}

base::Message messageOf(const Sentence& sentence, const std::smatch& found) {
  const auto kind =
      std::ranges::find_if(kMessages, [&](const auto& k) { return k.key == sentence.key; });
  std::vector<base::Argument> arguments;
  for (std::size_t i = 0; i < sentence.arguments.size(); ++i) {
    arguments.push_back(argumentOf(sentence.arguments[i], found[i + 1]));
  }
  return {*kind, std::move(arguments)};
}

/// The message whose sentence begins at @p at; moves @p at to its end.
std::optional<base::Message> next(
    std::string::const_iterator& at, std::string::const_iterator end) {
  static const auto kPatterns = [] {
    std::vector<std::regex> patterns;
    for (const auto& sentence : kSentences) patterns.push_back(patternOf(sentence));
    return patterns;
  }();
  for (std::size_t i = 0; i < kSentences.size(); ++i) {
    std::smatch found;
    constexpr auto kFromHere = std::regex_constants::match_continuous;
    if (!std::regex_search(at, end, found, kPatterns[i], kFromHere)) continue;
    at = found[0].second;
    return messageOf(kSentences[i], found);
  }
  return std::nullopt;
}

}  // namespace

base::NamedArguments valuesIn(EventKind kind, std::string_view detail) {
  if (kind != EventKind::Answered) return {};
  if (detail.ends_with(kKeptApart)) {
    const auto item = detail.substr(0, detail.size() - kKeptApart.size());
    if (item.find(' ') == item.npos) {
      return {{"item", std::string(item)}, {"kept_apart", std::int64_t{1}}};
    }
  }
  return {{"item", std::string(detail.substr(0, detail.find(' ')))}};
}

std::string detailOf(const GivenAnswer& answer) {
  const auto response = stored(answer.response);
  if (response.point) return answer.item + " = " + std::to_string(*response.point);
  if (response.number) return answer.item + " = " + shortest(*response.number);
  const std::string text = response.text.value_or("");
  return answer.item + " = " +
         (text.size() > kLongestText ? "sha256:" + sha256(text) : "'" + text + "'");
}

std::vector<base::Message> trialReasonsIn(const std::string& sentence) {
  std::vector<base::Message> reasons;
  auto at = sentence.begin();
  while (at != sentence.end()) {
    auto reason = next(at, sentence.end());
    if (!reason) return {base::Message::verbatim(sentence)};
    reasons.push_back(std::move(*reason));
  }
  // An export must give the stored sentence exactly.
  return base::describe(reasons) == sentence ? reasons
                                             : std::vector{base::Message::verbatim(sentence)};
}

}  // namespace study::storage::release_0_1
