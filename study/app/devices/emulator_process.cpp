#include "study/app/devices/emulator_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <string_view>

#include "haptics/devices/datagram_socket.h"
#include "haptics/emulators/fri_arm.h"
#include "study/app/sibling_program.h"
#include "study/model/user_error.h"

extern char** environ;

namespace study::app {
namespace {

constexpr int kLongestWait = 10'000;  // [ms]

void makePipe(std::array<int, 2>& ends) {
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe can be had");
}

}  // namespace

EmulatorProcess::EmulatorProcess(const std::vector<std::string>& arguments) {
  start(arguments);
  if (readLine(outputPipe_, ready_) && ready_.starts_with("ready ")) {
    ready_ = ready_.substr(6);
    return;
  }
  std::string why = ready_;
  end();
  for (std::string line; readLine(errorPipe_, line);) why += (why.empty() ? "" : "\n") + line;
  ::close(errorPipe_);
  constexpr std::string_view kName = "palpate: ";
  if (why.starts_with(kName)) why.erase(0, kName.size());
  throw UserError("The emulator of a device did not start" + (why.empty() ? "." : ": " + why));
}

void EmulatorProcess::start(const std::vector<std::string>& arguments) {
  std::array<int, 2> in{};
  std::array<int, 2> out{};
  std::array<int, 2> errors{};
  makePipe(in);
  makePipe(out);
  makePipe(errors);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors[1], STDERR_FILENO);
  std::vector<std::string> texts{"palpate", "device", "emulate"};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  texts.emplace_back("--until-input-ends");  // this program's end closes the pipes in any case
  std::vector<char*> words;
  for (auto& text : texts) words.push_back(text.data());
  words.push_back(nullptr);
  const auto program = siblingProgram(texts.front());
  const int error = posix_spawn(&id_, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(in[0]);
  ::close(out[1]);
  ::close(errors[1]);
  inputPipe_ = in[1];
  outputPipe_ = out[0];
  errorPipe_ = errors[0];
  if (error != 0) id_ = -1;
}

EmulatorProcess::~EmulatorProcess() {
  end();
  ::close(errorPipe_);
}

void EmulatorProcess::end() noexcept {
  ::close(inputPipe_);
  ::close(outputPipe_);
  if (id_ <= 0) return;
  kill(id_, SIGTERM);
  waitpid(id_, nullptr, 0);
}

bool EmulatorProcess::readLine(int from, std::string& line) {
  for (;;) {
    const auto end = buffer_.find('\n');
    if (end != std::string::npos) {
      line = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return true;
    }
    pollfd watched{.fd = from, .events = POLLIN, .revents = 0};
    if (poll(&watched, 1, kLongestWait) <= 0) return false;
    std::array<char, 512> bytes{};
    const ssize_t count = read(from, bytes.data(), bytes.size());
    if (count <= 0) return false;
    buffer_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

std::string EmulatorProcess::ask(const std::string& line) {
  const std::string text = line + "\n";
  if (write(inputPipe_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) return {};
  std::string answer;
  return readLine(outputPipe_, answer) ? answer : std::string();
}

std::string valueIn(std::string_view line, std::string_view key) {
  const std::string all = " " + std::string(line) + " ";
  const std::string start = " " + std::string(key) + "=";
  const auto at = all.find(start);
  if (at == std::string::npos) {
    throw UserError("The answer of an emulator has no " + std::string(key) + ".");
  }
  const auto begin = at + start.size();
  return all.substr(begin, all.find(' ', begin) - begin);
}

EmulatedDevice emulatedDevice(
    const haptics::devices::DeviceKind& kind,
    const std::string& id,
    const std::vector<std::string>& options) {
  std::vector<std::string> words;
  const auto start = [&] {
    words.insert(words.end(), options.begin(), options.end());
    return std::make_unique<EmulatorProcess>(words);
  };
  switch (kind.wire) {
    case haptics::devices::Wire::Serial: {
      words = {std::string(kind.name)};
      auto emulator = start();
      SerialPunchSettings settings{.punch = {.kind = &kind, .port = {}}};
      settings.punch.port = valueIn(emulator->ready(), "port");
      return {std::move(emulator), {id, settings}};
    }
    case haptics::devices::Wire::Fri: {
      const haptics::emulators::FriArm::Options arm;
      haptics::devices::IiwaSettings settings;
      settings.port = haptics::devices::DatagramSocket(haptics::devices::Endpoint{})
                          .local()
                          .port;  // a port that is free
      settings.model = arm.model;
      settings.tool.position.z() = arm.toolLength;
      settings.zero = arm.start;
      words = {"iiwa", "--client", "127.0.0.1:" + std::to_string(settings.port)};
      return {start(), {id, settings}};
    }
  }
  throw std::logic_error("no such wire");
}

}  // namespace study::app
