// A study with both devices at once on real wires, emulated by other processes: a normal session,
// and failures during a trial.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/emulators/pseudo_terminal.h"
#include "tests/study/app/emulated_devices.h"
#include "tests/support/programs.h"

namespace device_commands_test {

using tests::EmulatedLaboratory;
using tests::Emulator;

/// A value of a stored event: {"lost":2,…}.
std::uint64_t numberAfter(const std::string& text, const std::string& name) {
  const auto key = '"' + name + "\":";
  const auto at = text.find(key);
  if (at == std::string::npos) return 0;
  return std::stoull(text.substr(at + key.size()));
}

/// The sum over all trials on one device, which is recognised by its round trip.
std::uint64_t sumOver(const std::vector<std::string>& links, const std::string& word) {
  std::uint64_t sum = 0;
  for (const auto& link : links) sum += numberAfter(link, word);
  return sum;
}

/// Reads on until a line holds @p part; false at the end.
bool readUntil(tests::ChildProcess& process, const std::string& part) {
  for (std::string line; process.readLine(line);) {
    if (line.find(part) != std::string::npos) return true;
  }
  return false;
}

/// Processor time of a process [s].
double processorTime(pid_t id) {
  std::ifstream file("/proc/" + std::to_string(id) + "/stat");
  std::string line;
  std::getline(file, line);
  std::istringstream fields(line.substr(line.rfind(')') + 2));
  std::string field;
  double ticks = 0.0;
  for (int i = 3; i <= 15 && fields >> field; ++i) {
    if (i == 14 || i == 15) ticks += std::stod(field);
  }
  return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

class DeviceCommands : public testing::Test {
 protected:
  /// Checks that the study is complete, every trial was finished once, and the study verifies.
  void expectWholeStudy(std::size_t trials) {
    const auto endings = laboratory_.endings();
    EXPECT_EQ(
        static_cast<std::size_t>(std::count(endings.begin(), endings.end(), "finished")), trials)
        << testing::PrintToString(endings)
        << testing::PrintToString(laboratory_.events("device_fault"));
    const auto verified = laboratory_.palpate({"study", "verify", laboratory_.study()});
    EXPECT_EQ(verified.status, 0) << verified.out;
  }

  explicit DeviceCommands(int cuts = 1, int strokes = 1) : laboratory_(cuts, strokes) {}

  EmulatedLaboratory laboratory_;
};

/// Waits up to three seconds until @p isSo holds for its status; returns the status.
template <typename Predicate>
std::map<std::string, std::string> statusWhen(Emulator& emulator, Predicate isSo) {
  const auto until = tests::monotonic() + 3'000'000'000;
  auto status = emulator.status();
  while (!isSo(status) && tests::monotonic() < until) status = emulator.status();
  return status;
}

/// Why the hand on @p emulator does not get more than @p newtons: the output of the participant's
/// program. Empty if it does.
std::string whyNotFelt(Emulator& emulator, double newtons, tests::ChildProcess& participant) {
  const auto isWorthWaiting = [&] { return !participant.hasEnded(); };
  if (EmulatedLaboratory::waitForForce(emulator, newtons, isWorthWaiting)) return {};
  const auto status = emulator.ask("status");
  participant.kill(SIGTERM);
  const auto ended = participant.finish();
  return status + "\n" + ended.out + ended.error;
}

/// Trials that are long enough for a failure during one: the force of the first cut is seen, and a
/// second one follows.
class PunchFaults : public DeviceCommands {
 protected:
  PunchFaults() : DeviceCommands(2, 1) {}
};
class ArmFaults : public DeviceCommands {
 protected:
  ArmFaults() : DeviceCommands(1, 2) {}
};

constexpr std::size_t kTrials = 3 + 2;  // of the shipped protocol for both devices

TEST_F(DeviceCommands, CheckPassesForBothEmulators) {
  const auto checked = laboratory_.palpate(
      {"device",
       "check",
       laboratory_.deviceFile(),
       "--protocol",
       laboratory_.protocol(),
       "--seconds",
       "1.5",
       "--json"});
  ASSERT_EQ(checked.status, 0) << checked.out << checked.error;
  const auto json = nlohmann::json::parse(checked.out);
  EXPECT_TRUE(json["fit"]);
  ASSERT_EQ(json["devices"].size(), 2U);
  for (const auto& device : json["devices"]) {
    EXPECT_TRUE(device["fit"]) << device;
    EXPECT_GE(device["findings"].size(), 8U);
  }
}

TEST_F(DeviceCommands, RunAWholeSessionOnBothDevices) {
  auto participant = laboratory_.participant();
  const auto finished = participant->finish();
  ASSERT_EQ(finished.status, 0) << finished.error;
  expectWholeStudy(kTrials);
  const auto links = laboratory_.events("device_link");
  ASSERT_GE(links.size(), kTrials);  // a trial is repeated if the computer stood still
  for (const auto& link : links) {
    EXPECT_EQ(numberAfter(link, "lost") + numberAfter(link, "damaged"), 0U) << link;
  }
  EXPECT_GT(sumOver(links, "received"), 50U * kTrials);
}

TEST_F(DeviceCommands, RefuseAPortThatAnotherProgramUses) {
  auto participant = laboratory_.participant();
  const auto why = whyNotFelt(laboratory_.punch(), 0.5, *participant);
  ASSERT_EQ(why, "");
  const auto checked =
      laboratory_.palpate({"device", "check", laboratory_.deviceFile(), "--seconds", "0.5"});
  EXPECT_EQ(checked.status, 1);
  EXPECT_NE(checked.out.find("in use by another program"), std::string::npos) << checked.out;
}

TEST_F(PunchFaults, SwitchTheForceOffAndTheSessionContinues) {
  auto participant = laboratory_.participant();
  auto& punch = laboratory_.punch();
  const std::vector<std::pair<std::string, std::string>> faults{
      {"unplug", "plug"},
      {"mute 400", ""},
      {"stall 400", ""},
      {"leap 5000", "mend"},
      {"driver-fault", "mend"},
      {"reset", ""}};
  for (const auto& [fault, mend] : faults) {
    const auto why = whyNotFelt(punch, 0.5, *participant);
    ASSERT_EQ(why, "") << fault;
    ASSERT_EQ(punch.ask(fault), "ok " + fault);
    ASSERT_TRUE(readUntil(*participant, "broken off")) << fault;
    // The line that was read may belong to an earlier fault.
    const auto status =
        statusWhen(punch, [](auto& told) { return std::stod(told.at("let_go_ms")) >= 0.0; });
    EXPECT_GE(std::stod(status.at("let_go_ms")), 0.0) << fault;
    EXPECT_LE(std::stod(status.at("let_go_ms")), 50.0) << fault;
    if (fault == "unplug") {
      const double before = processorTime(participant->id());
      std::this_thread::sleep_for(std::chrono::seconds(1));
      EXPECT_LT(processorTime(participant->id()) - before, 0.05) << "of a second";
    }
    if (!mend.empty()) {
      ASSERT_EQ(punch.ask(mend), "ok " + mend);
    }
  }
  const auto finished = participant->finish();
  ASSERT_EQ(finished.status, 0) << finished.error;
  expectWholeStudy(kTrials);
  const auto endings = laboratory_.endings();
  EXPECT_GE(std::count(endings.begin(), endings.end(), "aborted_hardware"), 6);
  EXPECT_GE(laboratory_.events("device_fault").size(), 6U);
}

/// Milliseconds from @p at until the force on @p emulator was switched off; negative if it was not.
double offAfter(Emulator& emulator, std::int64_t at) {
  const auto zeroAt = [](const auto& told) { return std::stoll(told.at("zero_at_ns")); };
  const auto status = statusWhen(emulator, [&](const auto& told) { return zeroAt(told) >= at; });
  return 1e-6 * static_cast<double>(zeroAt(status) - at);
}

TEST_F(PunchFaults, SwitchTheForceOffWhenTheProgramIsFrozenOrKilled) {
  auto participant = laboratory_.participant();
  auto& punch = laboratory_.punch();
  for (const int signal : {SIGSTOP, SIGKILL}) {
    // After it was frozen, this also shows that the session goes on.
    const auto why = whyNotFelt(punch, 0.5, *participant);
    ASSERT_EQ(why, "") << signal;
    const auto at = tests::monotonic();
    participant->kill(signal);
    const double after = offAfter(punch, at);
    EXPECT_GT(after, 0.0) << signal;
    EXPECT_LE(after, 50.0) << signal;
    EXPECT_EQ(punch.status().at("voltage_mv"), "0") << signal;
    if (signal == SIGSTOP) participant->kill(SIGCONT);
  }
}

TEST_F(ArmFaults, SwitchTheForceOffWhenTheProgramIsKilled) {
  constexpr double kElevenAnswers = 11 * 5.0;  // [ms]
  auto participant = laboratory_.participant();
  auto& iiwa = laboratory_.iiwa();
  const auto why = whyNotFelt(iiwa, 5.0, *participant);
  ASSERT_EQ(why, "");
  const auto at = tests::monotonic();
  participant->kill(SIGKILL);
  const double after = offAfter(iiwa, at);
  EXPECT_GT(after, 0.0);
  EXPECT_LE(after, kElevenAnswers + 10.0) << "two periods go by before it is seen";
}

TEST_F(PunchFaults, ThatPersistEndTheSessionWithAnError) {
  auto participant = laboratory_.participant();
  const auto why = whyNotFelt(laboratory_.punch(), 0.5, *participant);
  ASSERT_EQ(why, "");
  ASSERT_EQ(laboratory_.punch().ask("driver-fault"), "ok driver-fault");
  const auto finished = participant->finish();
  EXPECT_EQ(finished.status, 1) << finished.out;
  for (const std::string part :
       {"SIM-001 step ",
        "attempt 2: broken off: ",
        "; repeated\n",
        "the motor's driver reports a fault; given up\n",
        "0 simulated participants have finished, 1 ended as aborted_hardware (SIM-001 at step "}) {
    EXPECT_NE(finished.out.find(part), std::string::npos) << part << "\n" << finished.out;
  }
  EXPECT_LE(laboratory_.endings().size(), 1U + 2 * 5U);
}

TEST_F(ArmFaults, SwitchTheForceOffAndTheSessionContinues) {
  auto participant = laboratory_.participant();
  auto& iiwa = laboratory_.iiwa();
  const std::vector<std::pair<std::string, std::string>> faults{
      {"stall 400", ""},
      {"safety-stop", "safety-reset"},
      {"quality poor", "quality good"},
      {"wrong-version", "wrong-version"},
      {"six-joints 60", ""},
      {"restart", ""}};
  for (const auto& [fault, mend] : faults) {
    const auto why = whyNotFelt(iiwa, 5.0, *participant);
    ASSERT_EQ(why, "") << fault;
    const auto at = tests::monotonic();
    ASSERT_EQ(iiwa.ask(fault), "ok " + fault);
    ASSERT_TRUE(readUntil(*participant, "broken off")) << fault;
    const auto status =
        statusWhen(iiwa, [at](auto& told) { return std::stoll(told.at("zero_at_ns")) >= at; });
    const double after = 1e-6 * static_cast<double>(std::stoll(status.at("zero_at_ns")) - at);
    EXPECT_GT(after, 0.0) << fault;
    EXPECT_LE(after, 50.0 + 10.0) << fault << ": two periods go by before it is seen";
    if (!mend.empty()) {
      ASSERT_EQ(iiwa.ask(mend), "ok " + mend);
    }
    iiwa.ask("motion");
  }
  const auto finished = participant->finish();
  ASSERT_EQ(finished.status, 0) << finished.error;
  expectWholeStudy(kTrials);
}

TEST_F(DeviceCommands, CountFaultsOfMessagesExactly) {
  auto participant = laboratory_.participant();
  auto& punch = laboratory_.punch();
  auto& iiwa = laboratory_.iiwa();
  const std::vector<std::string> orders{"drop 7", "double 5", "reorder 4", "damage 3"};
  auto why = whyNotFelt(punch, 0.5, *participant);
  for (const auto& order : orders) ASSERT_EQ(punch.ask(order), "ok " + order);
  if (why.empty()) why = whyNotFelt(iiwa, 5.0, *participant);
  ASSERT_EQ(why, "");
  for (const auto* order : {"drop 3", "double 6", "reorder 2", "garbage 4", "impostor 8"}) {
    ASSERT_EQ(iiwa.ask(order), std::string("ok ") + order);
  }
  const auto finished = participant->finish();
  ASSERT_EQ(finished.status, 0) << finished.error;
  // A damaged frame counts as damaged and as lost.
  const auto links = laboratory_.events("device_link");
  EXPECT_EQ(sumOver(links, "lost"), 7U + 3U + 3U);
  EXPECT_EQ(sumOver(links, "doubled"), 5U + 6U);
  EXPECT_EQ(sumOver(links, "late"), 4U + 2U);
  EXPECT_EQ(sumOver(links, "damaged"), 3U + 4U);
  EXPECT_EQ(sumOver(links, "foreign"), 8U);
  expectWholeStudy(kTrials);
}

TEST(DeviceFirmware, UnderQemuGivesTheSameForcesAndItsEndIsDetected) {
  const std::string firmware = tests::punchFirmware();
  if (firmware.empty()) GTEST_SKIP() << "needs arm-none-eabi-g++ and QEMU: ./setup --firmware";
  tests::ScratchFolder folder;
  const std::string port = folder / "port";
  Emulator board({"punch", "--link", port, "--firmware", firmware});
  const auto file = folder.write(
      "devices.json",
      R"({"format": "palpate-devices-1", "devices": [{"id": "punch", "type": "punch-serial", "port": ")" +
          port + R"(", "newtons_per_volt": 0.667}]})");
  const auto checked =
      tests::run({tests::program(), "device", "check", file, "--seconds", "1", "--json"});
  const auto json = nlohmann::json::parse(checked.out, nullptr, false);
  ASSERT_EQ(json["devices"].size(), 1U) << checked.out << checked.error;
  const auto& findings = json["devices"][0]["findings"];
  EXPECT_GE(findings.size(), 7U) << findings;
  // QEMU shares its processor with other programs: the board's times are no times of a board.
  const std::set<std::string> times{
      "telemetry", "frames lost, doubled, late, damaged", "round trip"};
  for (const auto& finding : findings) {
    if (times.contains(finding["what"])) continue;
    EXPECT_EQ(finding["finding"], "PASS") << finding;
  }

  const std::string study = folder / "study";
  ASSERT_EQ(
      tests::run({tests::program(), "study", "create", study, "--protocol", "punch-face-validity"})
          .status,
      0);
  tests::ChildProcess participant(
      {tests::program(),
       "study",
       "simulate",
       study,
       "--participants",
       "1",
       "--devices",
       file,
       "--verbose"});
  ASSERT_TRUE(readUntil(participant, "benchmark done"));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  ASSERT_EQ(board.ask("kill"), "ok kill");
  EXPECT_TRUE(readUntil(participant, "broken off"));
}

TEST(DeviceFirmware, EndsWithAnEmulatorThatIsKilled) {
  const std::string firmware = tests::punchFirmware();
  if (firmware.empty()) GTEST_SKIP() << "needs arm-none-eabi-g++ and QEMU: ./setup --firmware";
  tests::ScratchFolder folder;
  std::filesystem::path process = "/proc";
  {
    Emulator board({"punch", "--link", folder / "port", "--firmware", firmware});
    process /= board.status().at("qemu_pid");
    ASSERT_TRUE(std::filesystem::exists(process));
  }  // by SIGKILL
  const auto until = tests::monotonic() + 20'000'000'000;
  while (std::filesystem::exists(process) && tests::monotonic() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_FALSE(std::filesystem::exists(process));
}

TEST(DeviceEmulators, AnswerHelpAndInvalidNumbersInTheSameWay) {
  tests::ScratchFolder folder;
  Emulator punch({"punch", "--link", folder / "port"});
  Emulator iiwa({"iiwa"});
  for (auto* emulator : {&punch, &iiwa}) {
    const auto help = emulator->ask("help");
    EXPECT_EQ(help.rfind("There are: drop N, double N, ", 0), 0U) << help;
    EXPECT_NE(help.find(", status, help, quit; N"), std::string::npos) << help;
    EXPECT_EQ(help.find("status"), help.rfind("status")) << help;
    const auto unknown = emulator->ask("dance");
    EXPECT_EQ(unknown, "error 'dance' is no command. " + help);
  }
  EXPECT_NE(iiwa.ask("help").find("delay N MS, "), std::string::npos);
  EXPECT_EQ(
      punch.ask("drop x"),
      "error 'drop x': N is a whole number from 1 to 1000000, such as \"drop 3\"");
  EXPECT_EQ(
      punch.ask("stall"),
      "error 'stall': MS is a whole number from 1 to 1000000, such as \"stall 400\"");
  EXPECT_EQ(
      iiwa.ask("delay 3"),
      "error 'delay 3': the command is \"delay N MS\"; N and MS are whole numbers from 1 to "
      "1000000");
}

TEST(DeviceEmulators, RefuseALinkThatAnotherEmulatorUses) {
  tests::ScratchFolder folder;
  const std::string port = folder / "port";
  Emulator punch({"punch", "--link", port});
  const auto second = tests::run(
      {tests::program(), "device", "emulate", "punch", "--link", port, "--seconds", "1"});
  EXPECT_EQ(second.status, 1);
  EXPECT_NE(second.error.find("another emulator has it"), std::string::npos) << second.error;
  EXPECT_NE(punch.ask("status").find("plugged=1"), std::string::npos);
}

TEST(DeviceRehearsal, EndsItsEmulatorsHoweverItEnds) {
  for (const int signal : {SIGTERM, SIGKILL}) {
    tests::ScratchFolder folder;
    const std::filesystem::path port = std::string(folder / "rehearsal/punch-port");
    tests::ChildProcess rehearsal(
        {tests::program(), "device", "rehearse", "--out", folder / "rehearsal"});
    const auto becomesTrue = [](const auto& isSo) {
      const auto until = tests::monotonic() + 20'000'000'000;
      while (!isSo() && tests::monotonic() < until) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      return isSo();
    };
    // The device file is written when both emulators have started.
    ASSERT_TRUE(
        becomesTrue([&] { return std::filesystem::exists(folder / "rehearsal/devices.json"); }));
    ASSERT_TRUE(std::filesystem::is_symlink(port));
    rehearsal.kill(signal);
    EXPECT_TRUE(becomesTrue([&] { return !std::filesystem::is_symlink(port); }))
        << "an emulator removes its name when it ends";
    EXPECT_EQ(rehearsal.finish().status, -signal);
  }
}

TEST(DeviceRehearsal, LeavesNoFolderIfNothingWasRecorded) {
  tests::ScratchFolder folder;
  const std::string out = folder / "rehearsal";
  const auto refused = tests::run(
      {tests::program(),
       "device",
       "rehearse",
       "--out",
       out,
       "--protocol",
       "punch-face-validity",
       "--firmware",
       "nope.elf"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(
      refused.error.find("The emulator of a device did not start: nope.elf is no firmware"),
      std::string::npos)
      << refused.error;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(DeviceFiles, ThatAreInvalidAreReportedAsTextAndJson) {
  tests::ScratchFolder folder;
  const std::string none = folder / "none.json";
  const auto listed = tests::run({tests::program(), "device", "list", none});
  EXPECT_EQ(listed.status, 1);
  const auto checked = tests::run({tests::program(), "device", "check", none});
  EXPECT_EQ(checked.status, 1);
  EXPECT_NE(checked.error.find("docs/devices.md"), std::string::npos) << checked.error;
  const auto bad = folder.write("bad.json", R"({"format": "palpate-devices-1", "devices": []})");
  for (const auto& file : {none, bad}) {
    const auto told = tests::run({tests::program(), "device", "check", file, "--json"});
    EXPECT_EQ(told.status, 1);
    const auto json = nlohmann::json::parse(told.out);
    EXPECT_FALSE(json["fit"]);
    ASSERT_EQ(json["problems"].size(), 1U);
    EXPECT_NE(json["problems"][0].get<std::string>().find(file), std::string::npos);
    EXPECT_TRUE(json["devices"].empty());
  }
}

TEST(DeviceListen, SuggestsWhatToCheckIfNoDataArrive) {
  tests::ScratchFolder folder;
  const haptics::emulators::PseudoTerminal line(folder / "port");
  const std::string out = folder / "heard.csv";
  const auto heard = tests::run(
      {tests::program(), "device", "listen", line.port(), "--seconds", "0.3", "--out", out});
  EXPECT_EQ(heard.status, 1);
  EXPECT_NE(heard.error.find("the published sketch on the board"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(DeviceListen, RecordsWhatThePublishedSketchPrints) {
  tests::ScratchFolder folder;
  haptics::emulators::PseudoTerminal line(folder / "port");
  tests::ChildProcess listening(
      {tests::program(), "device", "listen", line.port(), "--seconds", "2"});
  std::string header;
  ASSERT_TRUE(listening.readLine(header));
  const auto print = [&](const std::string& text) {
    line.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  print("0.10,0.20,0.30,0.40,0.50\r\n");
  print("1.50\t2.25\t1.75\t\r\n");
  print("Motor ready\r\n");
  const auto heard = listening.finish();
  EXPECT_EQ(heard.status, 0) << heard.error;
  EXPECT_NE(heard.out.find(",mesh,0.4,"), std::string::npos) << heard.out;
  EXPECT_NE(heard.out.find(",forces,,1.5,2.25,1.75"), std::string::npos) << heard.out;
  EXPECT_NE(heard.error.find("2 lines of the published sketch, 1 others"), std::string::npos);
}

}  // namespace device_commands_test
