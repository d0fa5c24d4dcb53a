#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "protocols/load_protocol.h"
#include "protocols/orders/schedule.h"
#include "study/app/command_options.h"
#include "study/app/json_file.h"
#include "study/results/balance_words.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

using words::counted;

struct CheckArguments {
  std::string file;
  bool json = false;
};

int check(const CheckArguments& options) {
  questionnaires::Problems problems;
  const auto loaded = protocols::loadProtocolFile(options.file, problems);
  if (options.json) {
    std::fputs(problemsAsJson(options.file, loaded.has_value(), problems.all()).c_str(), stdout);
    return loaded ? 0 : 1;
  }
  std::fputs(questionnaires::describe(problems.all()).c_str(), stdout);
  if (!loaded) {
    fmt::print("{} cannot be used yet.\n", options.file);
    return 1;
  }
  const auto& protocol = loaded->protocol;
  fmt::print(
      "{} is valid: \"{}\", {}, {}, {}.\n",
      options.file,
      protocol.study.title,
      counted(protocol.conditions.size(), "condition"),
      counted(protocol.phases.size(), "phase"),
      counted(protocol.cohorts.size(), "cohort"));
  return 0;
}

struct ListArguments {};

int list(const ListArguments& /*options*/) {
  for (const auto& name : protocols::libraryProtocols()) {
    questionnaires::Problems problems;
    const auto loaded = protocols::loadProtocol(
        protocols::libraryProtocol(name).value(),
        [](const std::string&) { return std::nullopt; },
        problems);
    const auto& protocol = loaded.value().protocol;
    fmt::print(
        "{:<22} {:<13} {}\n",
        name,
        counted(protocol.conditions.size(), "condition"),
        protocol.study.title);
  }
  return 0;
}

struct OrdersArguments {
  std::string file;
  std::size_t participants = 0;
  std::optional<std::uint64_t> seed;
  bool csv = false;
};

/// Prints the trials of all participants as CSV, one row each.
void printTrials(
    const protocols::Protocol& protocol, const OrdersArguments& options, std::uint64_t seed) {
  fmt::print("cohort,participant,block,position,alternative,condition\n");
  for (const auto& cohort : protocol.cohorts) {
    for (std::size_t slot = 0; slot < options.participants; ++slot) {
      for (const auto& block : protocols::scheduleFor(protocol, seed, cohort.id, slot).blocks) {
        for (const auto& trial : block.trials) {
          fmt::print(
              "{},{},{},{},{},{}\n",
              cohort.id,
              slot + 1,
              block.phase,
              trial.position,
              trial.label,
              trial.condition);
        }
      }
    }
  }
}

/// Numbers in a list: "1, 4, 7", shortened to eight.
std::string participantList(const std::vector<std::size_t>& people) {
  constexpr std::size_t kShown = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(people.size(), kShown); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(people[i]);
  }
  return people.size() > kShown ? text + ", …" : text;
}

/// An order of conditions, with the labels if they are the same for all participants with this
/// order.
std::string describeOrder(
    const protocols::Protocol& protocol, const protocols::PlannedBlock& block) {
  std::string text;
  for (const auto& trial : block.trials) {
    text += (text.empty() ? "" : " → ") + trial.condition;
    if (protocol.labels.policy != protocols::LabelPolicy::Random) {
      text += fmt::format(" ({})", trial.label);
    }
  }
  return text;
}

/// Prints each distinct order once, with its participants.
void printOrders(
    const protocols::Protocol& protocol, const OrdersArguments& options, std::uint64_t seed) {
  for (const auto& cohort : protocol.cohorts) {
    std::map<std::string, std::vector<std::pair<std::string, std::vector<std::size_t>>>> byPhase;
    for (std::size_t slot = 0; slot < options.participants; ++slot) {
      for (const auto& block : protocols::scheduleFor(protocol, seed, cohort.id, slot).blocks) {
        auto& found = byPhase[block.phase];
        const std::string order = describeOrder(protocol, block);
        auto same =
            std::ranges::find_if(found, [&](const auto& one) { return one.first == order; });
        if (same == found.end()) same = found.insert(found.end(), {order, {}});
        same->second.push_back(slot + 1);
      }
    }
    fmt::print("{}\n", cohort.id);
    for (const auto& [phase, found] : byPhase) {
      for (const auto& [order, people] : found) {
        fmt::print(
            "  {:>4} ×  {}: {}   [{}]\n", people.size(), phase, order, participantList(people));
      }
    }
  }
  const bool isRandom = protocol.labels.policy == protocols::LabelPolicy::Random;
  fmt::print(
      "How many of {} feel each order, and who, counted from 1 in each cohort.{}\n",
      options.participants,
      isRandom ? " Labels are drawn for everybody: --csv has them." : " In brackets: the label.");
}

int orders(const OrdersArguments& options) {
  const auto loaded = loadOrPrintProblems(options.file);
  if (!loaded) return 1;
  const auto& protocol = loaded->protocol;
  const std::uint64_t seed = options.seed.value_or(protocol.seed.value_or(1));
  if (!options.csv && !options.seed && !protocol.seed) {
    fmt::print(
        "The protocol has no seed; every study draws its own. These are the orders of seed 1.\n\n");
  }
  if (options.csv) {
    printTrials(protocol, options, seed);
    return 0;
  }
  printOrders(protocol, options, seed);
  std::fputs(balanceInWords(protocol, options.participants, seed).c_str(), stdout);
  return 0;
}

}  // namespace

void addProtocolCommands(CLI::App& program, Action& action) {
  auto& parentCommand = addCommandGroup(
      program,
      "protocol",
      "List the protocols of the library; check a protocol, list its orders, fill in its texts");

  addCommand(parentCommand, action, "list", "List the protocols of the library", list);

  auto [check, checking] = addCommand(
      parentCommand,
      action,
      "check",
      "List all problems of a protocol, each with its place and a fix",
      app::check);
  addProtocolFile(*check, checking.file);
  check->add_flag("--json", checking.json, "Print JSON");

  auto [orders, ordering] = addCommand(
      parentCommand,
      action,
      "orders",
      "List the orders in which participants feel the conditions, and how balanced they are",
      app::orders);
  addProtocolFile(*orders, ordering.file);
  orders
      ->add_option("--participants", ordering.participants, "Number of participants in each cohort")
      ->required()
      ->check(CLI::Range(1, 100'000));
  orders->add_option(
      "--seed",
      ordering.seed,
      "Number that fixes the random orders (default: the protocol's, else 1); without one "
      "in the protocol, live sessions have other orders");
  orders->add_flag(
      "--csv",
      ordering.csv,
      "Print the trials of all participants as CSV, and leave out how balanced the orders are");

  addProtocolTextsCommand(parentCommand, action);
}

}  // namespace study::app
