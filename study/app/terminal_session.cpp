#include "study/app/terminal_session.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <initializer_list>
#include <iostream>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "base/text_table.h"
#include "haptics/devices/device.h"
#include "protocols/model/loaded_protocol.h"
#include "study/cohort/simulated_participant.h"
#include "study/model/user_error.h"
#include "study/session/trial_setup.h"
#include "study/trial/hardware_device_set.h"
#include "study/trial/live_trial.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

using questionnaires::AnswerKind;
using questionnaires::Item;
using questionnaires::Response;

constexpr double kLongestTrial = 600.0;  // [s]
constexpr int kMostTries = 20;           // each attempt waits up to 3 s for other programs

/// Thrown when the input ends.
struct InputEnded {};

std::string readLine() {
  std::fflush(stdout);
  std::string line;
  if (!std::getline(std::cin, line)) throw InputEnded();
  return line;
}

/// Whether @p word equals one of @p words, ignoring case.
bool isAmongWords(std::string word, std::initializer_list<std::string_view> words) {
  for (auto& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::ranges::find(words, word) != words.end();
}

bool isYes(const std::string& word) {
  return isAmongWords(word, {"y", "yes", "j", "ja"});
}

bool isNo(const std::string& word) {
  return isAmongWords(word, {"n", "no", "nein", "nei"});
}

/// Runs @p action, which stores data. While another program writes, retries and shows the operator
/// the reason: ten stations on one slow disk may wait for each other longer than SQLite's timeout.
/// A refused action has changed nothing, so a retry stores what was typed. After a minute the
/// program gives up; the session can be resumed later.
template <typename Action>
void storeWithRetries(const Action& action) {
  for (int tries = 1;; ++tries) {
    try {
      action();
      return;
    } catch (const storage::StorageError& error) {
      if (error.kind() != storage::StorageError::Kind::Busy || tries == kMostTries) throw;
      fmt::print(
          stderr,
          "Not stored yet. {} Trying again, {} of {}.\n",
          error.what(),
          tries,
          kMostTries - 1);
    }
  }
}

/// Runs one session in a terminal.
class TerminalSession {
 public:
  TerminalSession(Study& study, Session& session, const std::string& deviceFile)
      : study_(study),
        session_(session),
        deviceSet_(deviceSetFor(
            deviceFile, study.folder(), [this](const protocols::DeviceRequirement& need) {
              return simulatedHandFor(
                  need,
                  simulationSeed(study_),
                  session_.cohort(),
                  static_cast<std::uint64_t>(session_.slot()),
                  feedLimitOn(session_.protocol().protocol, need.id));
            })) {}

  void run() {
    warnOfSimulatedHand();
    fmt::print(
        "{} ({}, {}). Empty line: leave a question out, where that is allowed. Ctrl-D: stop; the "
        "session "
        "can be continued later.\n",
        session_.participant(),
        session_.cohort(),
        nameOf(session_.runMode()));
    while (!session_.isOver()) step();
    fmt::print("\nThis session is over: {}.\n", statusOf(session_.state()));
  }

 private:
  /// A live session without devices would be told as one in which people felt forces.
  void warnOfSimulatedHand() const {
    const bool isSimulated = dynamic_cast<const SimulatedDeviceSet*>(deviceSet_.get()) != nullptr;
    if (!isSimulated || session_.runMode() != RunMode::Live) return;
    fmt::print(
        stderr,
        "WARNING: there is no device file, so that a simulated hand moves the devices of this live "
        "session, and the participant feels nothing. Name the laboratory's devices with --devices "
        "FILE, or try the study with --pilot.\n");
  }

  const std::string& language() const { return session_.language(); }

  /// The label of an alternative, as the participant reads it.
  std::string alternative(const std::string& number) const {
    return session_.protocol().protocol.labels.nameOf(number, language());
  }

  void step() {
    if (session_.state() == SessionState::Interrupted) {
      fmt::print("\nThe last trial broke off. It begins again.\n");
      storeWithRetries([&] { session_.repeatStep("continued in the terminal"); });
    }
    if (session_.state() == SessionState::Paused)
      storeWithRetries([&] { session_.resumeAfterPause(); });
    if (session_.step().kind == StepKind::Trial) {
      acceptsOffer() ? runTrial() : storeWithRetries([&] { session_.skipOptionalTrial(); });
      return;
    }
    if (const auto* instrument = session_.instrument()) {
      fmt::print("\n== {} ==\n", instrument->title.in(language()));
      const auto& words = instrument->introduction.in(language());
      if (!words.empty()) fmt::print("{}\n", words);
    }
    const auto* phase = session_.protocol().protocol.phase(session_.step().phase);
    if (!phase->text.isEmpty()) fmt::print("\n{}\n", phase->text.in(language()));
    if (session_.step().kind == StepKind::Benchmark) countCuts();
    askAll();
    storeWithRetries([&] { session_.finishStep(); });
  }

  /// Asks whether the participant wants an optional trial.
  bool acceptsOffer() {
    const auto& step = session_.step();
    if (!step.isOptionalTrial) return true;
    fmt::print(
        "\nFeel {} again before you choose? [y/N] ", alternative(std::to_string(step.label)));
    return isYes(readLine());
  }

  void countCuts() {
    const int needed = session_.step().minimumCuts;
    while (session_.benchmarkCuts() < needed) {
      fmt::print("How many cuts were made (at least {})? ", needed);
      const auto cuts = base::numberFrom<int>(readLine());
      if (cuts && *cuts >= 0) storeWithRetries([&] { session_.recordBenchmarkCuts(*cuts); });
    }
  }

  void askAll() {
    const auto items = session_.items();
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (!session_.isAsked(items[i])) continue;
      while (!ask(items[i], static_cast<int>(i) + 1, begin)) {
      }
    }
    if (items.empty()) {
      fmt::print("[Enter] ");
      readLine();
    }
  }

  /// Asks @p item once. Returns true if the answer is valid, or if the item was skipped.
  bool ask(const Item& item, int order, std::chrono::steady_clock::time_point begin) {
    print(item);
    const std::string line = readLine();
    if (line.empty() && !item.isRequired) return true;
    const auto response = parse(item, line);
    if (!response) {
      fmt::print("That is no answer to this question.\n");
      return false;
    }
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const GivenAnswer given{
        .item = item.id,
        .response = *response,
        .itemOrder = order,
        .firstTouch = seconds,
        .responseTime = seconds,
        .language = language()};
    try {
      storeWithRetries([&] { session_.record(given); });
    } catch (const UserError& objection) {
      fmt::print("{}\n", objection.what());
      return false;
    }
    return true;
  }

  void print(const Item& item) const {
    fmt::print("\n{}{}\n", item.text.in(language()), item.isRequired ? "" : " (optional)");
    if (!item.leftText.isEmpty()) {
      fmt::print("  {} … {}\n", item.leftText.in(language()), item.rightText.in(language()));
    }
    const auto kind = questionnaires::answerKindOf(item.type);
    if (kind == AnswerKind::Point) {
      fmt::print(
          "  {} {} … {} {}\n",
          item.scale.lowest,
          item.scale.lowLabel.in(language()),
          item.scale.highest(),
          item.scale.highLabel.in(language()));
    }
    if (kind == AnswerKind::Number) {
      fmt::print("  a number from {} to {} {}\n", item.least, item.most, item.unit);
    }
    for (const auto& option : optionsOf(item))
      fmt::print("  {}  {}\n", option.first, option.second);
    fmt::print("> ");
  }

  std::vector<std::pair<std::string, std::string>> optionsOf(const Item& item) const {
    std::vector<std::pair<std::string, std::string>> options;
    if (item.optionSource == questionnaires::OptionSource::Alternatives) {
      for (const auto& label : session_.alternatives()) {
        options.emplace_back(label, alternative(label));
      }
      return options;
    }
    for (const auto& option : item.options)
      options.emplace_back(option.id, option.text.in(language()));
    return options;
  }

  /// The option that is selected by "yes", "no" or their translations. Applies to items with two
  /// options, one of which gives consent or has the id "yes"; otherwise returns the typed text.
  static Response chosen(const Item& item, const std::string& line) {
    const bool saysYes = isYes(line);
    if (item.options.size() != 2 || (!saysYes && !isNo(line))) return line;
    const auto& first = item.options[0].id;
    const auto& second = item.options[1].id;
    const std::string yes = item.consentOption.empty() ? "yes" : item.consentOption;
    if (yes != first && yes != second) return line;
    return saysYes ? yes : (yes == first ? second : first);
  }

  static std::optional<Response> parse(const Item& item, const std::string& line) {
    switch (questionnaires::answerKindOf(item.type)) {
      case AnswerKind::Point:
        if (const auto point = base::numberFrom<std::int64_t>(line)) return *point;
        return std::nullopt;
      case AnswerKind::Number:
        if (const auto number = base::numberFrom<double>(line)) return *number;
        return std::nullopt;
      case AnswerKind::Options: {
        std::vector<std::string> ids;
        std::istringstream words(line);
        for (std::string id; words >> id;) ids.push_back(id);
        return ids;
      }
      case AnswerKind::Option:
      case AnswerKind::Text:
        break;
    }
    return chosen(item, line);
  }

  void runTrial() {
    const Step step = session_.step();
    const auto& kind = *deviceFor(session_).kind;
    const std::string stroke(kind.strokeName.in("en"));
    const std::string strokes(kind.strokesName.in("en"));
    fmt::print(
        "\n== {} == [Enter: then {} to be made] ",
        alternative(std::to_string(step.label)),
        words::counted(
            static_cast<std::uint64_t>(step.minimumCuts), stroke + " is", strokes + " are"));
    readLine();
    auto traces = study_.openTraces();
    std::unique_ptr<Trial> trial;
    try {
      trial = trialFor(session_, *deviceSet_, traces);
    } catch (const haptics::devices::DeviceError& error) {
      fmt::print("{}\n", error.what());
      return;  // the caller repeats the step
    }
    storeWithRetries([&] { session_.beginTrial(); });
    const auto record = runRealtime(*trial, step.minimumCuts, kLongestTrial);
    fmt::print(
        "{} in {:.1f} s.\n", words::counted(record.cuts.size(), stroke, strokes), record.duration);
    if (!record.deviceFault.empty()) fmt::print("{}.\n", record.deviceFault);
    storeWithRetries([&] {
      record.ending == TrialEnding::Finished ? session_.finishTrial(record)
                                             : session_.abortTrial(record);
    });
  }

  Study& study_;
  Session& session_;
  std::unique_ptr<DeviceSet> deviceSet_;
};

/// @throws UserError  if an option was given that is not as in the session that would go on
void requireSame(
    const storage::SessionRow& row,
    const char* option,
    const std::string& given,
    const std::string& present) {
  if (given.empty() || given == present) return;
  throw UserError(fmt::format(
      "The session of {0} is not finished, and would go on; there, {1} is '{2}', not '{3}'. To go "
      "on with it: --participant {0}, without {1}. For a new participant: --participant CODE, with "
      "a code that is not taken.",
      row.participant,
      option,
      present,
      given));
}

std::optional<SessionId> unfinishedSessionOf(Study& study, const Enrolment& enrolment) {
  for (const auto& row : study.sessions().all()) {
    const bool isMeant = enrolment.code.empty() || row.participant == enrolment.code;
    if (!isMeant || row.runMode != enrolment.runMode || isOver(row.state)) continue;
    requireSame(row, "--cohort", enrolment.cohort, row.cohort);
    requireSame(row, "--language", enrolment.language, row.language);
    return row.id;
  }
  return std::nullopt;
}

/// Whether a participant may be enrolled: not for a live session while a text that they would read
/// has blanks in double brackets. A pilot begins with a notice, because it does not count.
bool mayEnrol(Study& study, const Enrolment& enrolment) {
  const auto blanks = protocols::unfilledPlaceholdersIn(study.protocol());
  if (blanks.empty()) return true;
  const bool isPilot = enrolment.runMode == RunMode::Pilot;
  fmt::print(
      "{}",
      isPilot ? "These texts are still to be filled in before a live session:\n"
              : "A live session cannot begin: these texts are still to be filled in.\n");
  for (const auto& blank : blanks) fmt::print("  {}: {}\n", blank.where, blank.words);
  fmt::print(
      "Fill them in with 'palpate study texts'{}.\n",
      isPilot ? "" : ", or try the study with --pilot");
  return isPilot;
}

}  // namespace

int runInTerminal(
    Study& study, Enrolment enrolment, const std::string& deviceFile, const std::string& takeOver) {
  const auto open = unfinishedSessionOf(study, enrolment);
  if (enrolment.cohort.empty()) enrolment.cohort = study.protocol().protocol.cohorts.front().id;
  if (enrolment.language.empty()) enrolment.language = "en";
  if (!open && !mayEnrol(study, enrolment)) {
    fmt::print("No participant was enrolled.\n");
    return 1;
  }
  try {
    auto session =
        open ? Session::resume(study, *open, takeOver) : Session::enrol(study, enrolment);
    TerminalSession(study, session, deviceFile).run();
    return 0;
  } catch (const InputEnded&) {
    fmt::print("\nStopped. 'palpate study run' goes on from here.\n");
    return 1;
  }
}

}  // namespace study::app
