#include "tests/study/app/emulated_devices.h"

#include <time.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/study/storage/sql.h"
#include "tests/support/free_port.h"
#include "tests/support/programs.h"
#include "tests/support/test_data.h"

namespace tests {
namespace {

using nlohmann::ordered_json;

std::vector<std::string> emulate(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {tests::program(), "device", "emulate"});
  return arguments;
}

/// Time of the arm's hand for a stroke [s], and turns per second of a reamer that is fast enough
/// for it. Trials are in real time, and nothing is learnt while the hand advances slowly.
constexpr const char* kAdvance = "1.75";
constexpr int kReamerSpeed = 20;

/// The shipped protocol for both devices, with so many cuts and strokes in each trial.
std::string shortProtocol(int cuts, int strokes) {
  std::ifstream file((tests::repository() / "protocols/library/two-devices.json").string());
  auto json = ordered_json::parse(file);
  for (auto& phase : json["phases"]) {
    if (phase.contains("minimum_cuts"))
      phase["minimum_cuts"] = phase["id"] == "punching" ? cuts : strokes;
  }
  for (auto& condition : json["conditions"]) {
    auto& scene = condition["scene"];
    if (scene["device"] == "reamer") scene["reamer"] = {{"speed", kReamerSpeed}};
  }
  return json.dump(1);
}

std::string devicesAt(const std::string& punchPort, std::uint16_t iiwaPort) {
  const ordered_json punch{
      {"id", "punch"}, {"type", "punch-serial"}, {"port", punchPort}, {"newtons_per_volt", 0.667}};
  const ordered_json reamer{
      {"id", "reamer"},
      {"type", "iiwa-fri"},
      {"robot_address", "127.0.0.1"},
      {"port", iiwaPort},
      {"tool_m", {0.0, 0.0, 0.2}},
      {"zero_joints_deg", {0.0, 30.0, 0.0, -90.0, 0.0, 60.0, 0.0}}};
  ordered_json json{{"format", "palpate-devices-1"}};
  json["devices"] = {punch, reamer};
  return json.dump(1);
}

}  // namespace

Emulator::Emulator(std::vector<std::string> arguments)
    : process_(emulate(std::move(arguments)), {}, ChildProcess::Input::Pipe) {
  if (!process_.readLine(ready_) || ready_.rfind("ready ", 0) != 0) {
    throw std::runtime_error("the emulator did not begin: " + ready_);
  }
}

std::string Emulator::ask(const std::string& line) {
  process_.say(line);
  std::string answer;
  if (!process_.readLine(answer)) throw std::runtime_error("the emulator has ended");
  return answer;
}

std::map<std::string, std::string> Emulator::status() {
  std::map<std::string, std::string> values;
  std::istringstream words(ask("status"));
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals != std::string::npos) values[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return values;
}

EmulatedLaboratory::EmulatedLaboratory(int cuts, int strokes) : port_(folder_ / "punch-port") {
  const auto iiwaPort = tests::freePort();
  punch_ = std::make_unique<Emulator>(std::vector<std::string>{"punch", "--link", port_});
  iiwa_ = std::make_unique<Emulator>(std::vector<std::string>{
      "iiwa", "--client", "127.0.0.1:" + std::to_string(iiwaPort), "--advance", kAdvance});
  deviceFile_ = folder_.write("devices.json", devicesAt(port_, iiwaPort));
  protocol_ = folder_.write("protocol.json", shortProtocol(cuts, strokes));
  study_ = folder_ / "study";
  const auto made = palpate({"study", "create", study_, "--protocol", protocol_, "--seed", "5"});
  if (made.status != 0) throw std::runtime_error(made.error);
}

Finished EmulatedLaboratory::palpate(std::vector<std::string> call) const {
  call.insert(call.begin(), tests::program());
  return run(call);
}

std::unique_ptr<ChildProcess> EmulatedLaboratory::participant() const {
  return std::make_unique<ChildProcess>(std::vector<std::string>{
      tests::program(),
      "study",
      "simulate",
      study_,
      "--participants",
      "1",
      "--devices",
      deviceFile_,
      "--verbose"});
}

bool EmulatedLaboratory::waitForForce(
    Emulator& emulator, double newtons, const std::function<bool()>& isWorthWaiting) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::seconds(60);
  while (Clock::now() < until && isWorthWaiting()) {
    if (std::abs(emulator.number("force_n")) > newtons) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

std::vector<std::string> EmulatedLaboratory::column(
    const std::string& of, const std::string& from) const {
  const std::string newline = "char(10)";
  std::istringstream lines(Sql(study_ + "/study.db")
                               .text(
                                   "SELECT group_concat(value, " + newline + ") FROM (SELECT " +
                                   of + " AS value FROM " + from + ")"));
  std::vector<std::string> values;
  for (std::string line; std::getline(lines, line);) values.push_back(line);
  return values;
}

std::vector<std::string> EmulatedLaboratory::events(const std::string& kind) const {
  return column("detail", "event WHERE kind = '" + kind + "' ORDER BY seq");
}

std::vector<std::string> EmulatedLaboratory::endings() const {
  return column("ending", "trial ORDER BY session_id, step, attempt");
}

std::int64_t monotonic() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * 1'000'000'000 + time.tv_nsec;
}

}  // namespace tests
