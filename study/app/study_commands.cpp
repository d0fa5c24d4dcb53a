#include <algorithm>
#include <cstdio>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "protocols/load_protocol.h"
#include "questionnaires/reading/instrument_file.h"
#include "study/app/command_options.h"
#include "study/app/json_file.h"
#include "study/app/keys/ask_passphrase.h"
#include "study/app/simulated_endings.h"
#include "study/app/terminal_session.h"
#include "study/cohort/simulated_participant.h"
#include "study/results/protocol_versions.h"
#include "study/session/study_key.h"
#include "study/session/unfinished_sessions.h"
#include "study/session/verification.h"
#include "study/storage/evidence/signed_head.h"
#include "study/storage/records.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

using Access = storage::Database::Access;

struct StudyArguments {
  std::string folder;
  std::string protocol;
  std::string reason;
  std::string cohort;
  std::string participant;
  std::string devices;
  std::string runMode;
  std::string language;  ///< empty: en, or that of the session that goes on
  std::string takeOver;
  std::string out;
  int participants = 0;
  std::optional<std::uint64_t> seed;
  bool hasNamesPassphrase = false;
  bool verbose = false;
  bool json = false;
};

/// The line on the key of sealed conditions; empty if nothing is sealed.
std::string sealLineOf(Study& study) {
  const auto words = keyStatusText(study);
  return words.empty() ? words : "conditions: " + words + "\n";
}

/// The line with the commitment to the secret of orders and codes; empty for studies of release
/// 0.1.
std::string commitmentLineOf(Study& study) {
  const auto commitment = study.events().commitment();
  return commitment.empty()
             ? commitment
             : "commitment of orders and codes: " + storage::inGroupsOfFour(commitment) + "\n";
}

std::string keyAdviceOn(Study& study, const std::string& folder) {
  if (!study.isSealed()) return {};
  return fmt::format(
      "Conditions are sealed, and this account has the only key. Before the first participant, "
      "keep "
      "a copy of it apart: palpate study key export {} --out key.txt --reason \"a copy\"\n",
      asShellWord(folder));
}

/// The line on the station and site; empty for a study of one machine.
std::string stationLineOf(const Study& study) {
  if (study.isCollected()) return "collected from several stations: 'palpate collect' made it\n";
  const auto& station = study.station();
  return station.isNone() ? ""
                          : "station '" + station.label + "' of the site '" + station.site +
                                "': 'palpate collect status' says what has arrived\n";
}

int create(const StudyArguments& options) {
  SystemClock clock;
  const auto protocol = loadValidProtocol(options.protocol);
  std::string passphrase;
  if (options.hasNamesPassphrase) passphrase = askNewPassphrase(kAskNewNamesPassphrase);
  auto study = Study::create(options.folder, protocol, clock, options.seed);
  if (options.hasNamesPassphrase) {
    setPassphraseOfNames(study, passphrase, "when the study was made");
  }
  fmt::print(
      "{} is ready: \"{}\", seed {}.\n{}{}Next: palpate-studio {}, or try it first: palpate study "
      "simulate "
      "{} --participants {}\n",
      options.folder,
      protocol.protocol.study.title,
      study.seed(),
      commitmentLineOf(study),
      keyAdviceOn(study, options.folder),
      asShellWord(options.folder),
      asShellWord(options.folder),
      plannedParticipants(protocol.protocol));
  return 0;
}

std::string keysOf(const questionnaires::BlankTexts& texts) {
  std::string keys;
  for (const auto& [key, text] : texts) keys.append(keys.empty() ? "" : ", ").append(key);
  return keys;
}

/// Saves the protocol as the study has it, to be changed and to become an amendment.
int saveProtocol(const StudyArguments& options) {
  auto study = Study::open(options.folder, Access::ReadOnly);
  study::saveProtocol(study.protocol(), options.out);
  fmt::print(
      "Protocol saved: {0}\nChange it, and: palpate study amend {1} --protocol {0} --reason "
      "\"…\"\n",
      options.out,
      options.folder);
  return 0;
}

int amend(const StudyArguments& options) {
  const auto changed = loadValidProtocol(options.protocol);
  auto study = Study::open(options.folder);
  const auto kept = protocols::keptTexts(study.protocol(), changed);
  const auto protocol = protocols::withKeptTexts(study.protocol(), changed);
  if (isSame(study.protocols().current(), protocol)) {
    fmt::print(
        "{} is what {} uses already, to the byte: nothing has changed.\n",
        options.protocol,
        options.folder);
    return 0;
  }
  const auto changes = changesBy(study, protocol);
  study.amend(protocol, options.reason);
  if (!changes.empty()) {
    fmt::print("What was answered or felt so far means something else in this version:\n");
    for (const auto& change : changes) fmt::print("  {}\n", base::describe(change));
    fmt::print(
        "Results will say so. To keep both apart, give what is changed an id of its own, or make a "
        "new study.\n");
  }
  fmt::print("New sessions use {} from now on.\n", options.protocol);
  printNeedOfServer(study);
  if (!kept.empty()) fmt::print("Texts kept from the study: {}.\n", keysOf(kept));
  return 0;
}

int countSimulatedSessions(Study& study) {
  const auto all = study.sessions().all();
  return static_cast<int>(std::ranges::count_if(
      all, [](const auto& row) { return row.runMode == RunMode::Simulated; }));
}

/// Prints the progress of a long simulation at some enrolments; the previous participant has then
/// finished.
void printProgress(const SimulationEvent& done, int& finished, int participants) {
  constexpr int kParticipantsPerReport = 10;
  if (done.kind != SimulationEvent::Kind::Enrolment) return;
  if (finished > 0 && finished % kParticipantsPerReport == 0) {
    fmt::print(stderr, "{} of {} simulated participants have finished\n", finished, participants);
  }
  ++finished;
}

int simulate(const StudyArguments& options) {
  SimulatedClock clock;
  auto study = Study::open(options.folder, clock);
  const int participants = options.participants > 0
                               ? options.participants
                               : plannedParticipants(study.protocol().protocol);
  const int sessionsBefore = countSimulatedSessions(study);
  int finished = sessionsBefore;
  const auto acknowledge = [&](const SimulationEvent& done) {
    printProgress(done, finished, participants);
    if (!options.verbose) return;
    fmt::print("saved {}\n", done.what);
    std::fflush(stdout);
  };
  const auto endings = simulateCohorts(
      study,
      clock,
      participants,
      options.seed.value_or(simulationSeed(study)),
      acknowledge,
      options.devices);
  const int now = static_cast<int>(endings.size());
  if (now > sessionsBefore) study.transact([&] { study.signTrail("simulated"); });
  fmt::print(
      "{} finished{}{}. Nobody took part: these answers say nothing about "
      "any method.\n",
      words::counted(
          static_cast<std::uint64_t>(countCompleted(endings)),
          "simulated participant has",
          "simulated participants have"),
      describeIncomplete(endings),
      sessionsBefore == 0 ? ""
      : sessionsBefore == now
          ? ", all of them begun before: no more were asked for, and none was added"
          : fmt::format(", {} of them begun before", sessionsBefore));
  return countCompleted(endings) == now ? 0 : 1;
}

int run(const StudyArguments& options) {
  auto study = Study::open(options.folder);
  askForKeyIfLocked(study);
  askForNamesIfLocked(study);
  return runInTerminal(
      study,
      {.cohort = options.cohort,
       .runMode = runModeNamed(options.runMode).value_or(RunMode::Live),
       .language = options.language,
       .code = options.participant},
      options.devices,
      options.takeOver);
}

int status(const StudyArguments& options) {
  auto study = Study::open(options.folder, Access::ReadOnly);
  if (options.json) {
    std::fputs(statusAsJson(study).c_str(), stdout);
    return 0;
  }
  const auto rights = describeOtherAccess(options.folder);
  const auto current = study.protocols().current();
  const auto& metadata = study.protocol().protocol.study;
  fmt::print(
      "{}\nprotocol {} version {}, SHA-256 {}…, {}\nmade {}\n{}{}{}{}{}\n",
      metadata.title,
      metadata.id,
      metadata.version,
      current.sha256.substr(0, 12),
      current.frozenUtc ? "frozen " + *current.frozenUtc
      : study.protocols().isAnyFrozen()
          ? "not frozen yet: live participants have begun with earlier "
            "versions only"
          : "not frozen yet: no live participant has begun",
      study.createdUtc(),
      stationLineOf(study),
      commitmentLineOf(study),
      sealLineOf(study),
      study.protocol().protocol.isOpenLabel
          ? "blinding: open, conditions are not hidden from anyone\n"
          : "",
      rights.empty() ? rights : "rights: " + rights + "\n");
  const auto sessions = storage::Records(study.database()).sessions();
  std::size_t width = 12;  // codes are seldom longer
  for (const auto& s : sessions) width = std::max(width, s.participant.size());
  fmt::print(
      "{:>4}  {:<{}} {:<20} {:<10} {:>5}  {:<17} {}\n",
      "id",
      "participant",
      width,
      "cohort",
      "run mode",
      "place",
      "status",
      "began");
  for (const auto& s : sessions) {
    fmt::print(
        "{:>4}  {:<{}} {:<20} {:<10} {:>5}  {:<17} {}\n",
        static_cast<std::int64_t>(s.id),
        s.participant,
        width,
        s.cohort,
        nameOf(s.runMode),
        s.slot + 1,
        statusOf(s.state),
        s.startedUtc);
  }
  for (const auto& session : unfinishedSessions(study)) {
    fmt::print("\n{}\n", describe(session));
    for (const auto& choice : session.choices) fmt::print("  - {}\n", choice);
  }
  return 0;
}

}  // namespace

void addStudyCommands(CLI::App& program, Action& action) {
  auto& parentCommand = addCommandGroup(
      program, "study", "Create, run and manage a study: sessions, keys, backups, checks, erasure");
  const auto add = [&](const char* name, const char* help, int (*perform)(const StudyArguments&)) {
    auto added = addCommand(parentCommand, action, name, help, perform);
    addStudyFolder(*added.command, added.options.folder);
    return added;
  };

  auto [create, creating] = add("create", "Create a study from a protocol", app::create);
  addProtocolFile(*create, creating.protocol, "--protocol").type_name("FILE");
  create->add_option(
      "--seed", creating.seed, "Random seed (default: the protocol's, otherwise a new one)");
  create->add_flag(
      "--names-passphrase",
      creating.hasNamesPassphrase,
      "Ask for a passphrase that is needed to read or add names; if it is forgotten, the names are "
      "lost");

  auto [run, running] =
      add("run", "Run a session in the terminal, or resume an interrupted one", app::run);
  run->add_option(
         "--cohort",
         running.cohort,
         "Cohort of a new participant (default: the first); when a session is resumed it must be "
         "that "
         "session's cohort")
      ->type_name("NAME");
  run->add_option(
         "--participant", running.participant, "Participant code (default: the next free one)")
      ->type_name("CODE");
  run->add_option(
      "--language",
      running.language,
      "Language of the texts, one of the protocol's: en, de, nb … (default: en)");
  addRunModeOfSession(*run, running.runMode);
  run->add_option(
         "--devices",
         running.devices,
         "The laboratory's device file (default: devices.json in the study's folder; without it, "
         "a simulated hand moves simulated devices, and a live session warns of that)")
      ->type_name("FILE");
  run->add_option(
      "--take-over",
      running.takeOver,
      "Reason for taking over a session of a lost or renamed computer; recorded in the audit "
      "trail");

  auto [simulate, simulating] =
      add("simulate", "Simulate participants, through the same steps as a session", app::simulate);
  simulate
      ->add_option(
          "--participants",
          simulating.participants,
          "Simulate until this many have finished (default: as planned in the protocol)")
      ->check(CLI::Range(1, 100'000));
  simulate->add_option(
      "--seed",
      simulating.seed,
      "Seed of the simulated hands and answers (default: the study's seed; at a station of a study "
      "at several sites, a seed that is derived from it)");
  simulate
      ->add_option(
          "--devices",
          simulating.devices,
          "Use the devices of this file, in real time (default: simulated devices, as fast as "
          "possible)")
      ->type_name("FILE");
  simulate->add_flag("--verbose", simulating.verbose, "Print each answer as soon as it is saved");

  auto [amend, amending] =
      add("amend", "Replace the protocol of a study by a changed one (an amendment)", app::amend);
  amend
      ->add_option(
          "--protocol",
          amending.protocol,
          "Changed protocol: a file (.json), or a name from 'palpate protocol list'")
      ->type_name("FILE")
      ->required();
  addReasonOfAmendment(*amend, amending.reason);

  auto [protocol, saving] =
      add("protocol",
          "Save the protocol that new sessions use, with its texts and the files that it names",
          app::saveProtocol);
  protocol->add_option("--out", saving.out, "New file for the protocol (.json)")
      ->type_name("FILE")
      ->required();

  auto [status, showing] =
      add("status", "Show participants and the progress of the study", app::status);
  status->add_flag("--json", showing.json, "Print JSON");

  addEvidenceCommands(parentCommand, action);
  addKeyCommands(parentCommand, action);
  addStudyTextsCommand(parentCommand, action);
  addConsentCommand(parentCommand, action);
  addErasureCommands(parentCommand, action);
  addPersonCommands(parentCommand, action);
}

}  // namespace study::app
