#include "tests/support/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>
#include <utility>

extern char** environ;

namespace tests {
namespace {

std::vector<char*> pointersTo(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> withOurs(const std::vector<std::string>& environment) {
  std::vector<std::string> all = environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string ours = *entry;
    const std::string name = ours.substr(0, ours.find('=') + 1);
    const bool isReplaced = std::any_of(environment.begin(), environment.end(), [&](const auto& e) {
      return e.compare(0, name.size(), name) == 0;
    });
    if (!isReplaced) all.push_back(ours);
  }
  return all;
}

/// Appends what can be read now; false at the end.
bool readSome(int file, std::string& text) {
  std::array<char, 65536> some{};
  const auto count = read(file, some.data(), some.size());
  if (count > 0) text.append(some.data(), static_cast<std::size_t>(count));
  return count > 0;
}

}  // namespace

ChildProcess::ChildProcess(
    const std::vector<std::string>& arguments,
    const std::vector<std::string>& environment,
    Input input) {
  std::array<int, 2> in{-1, -1};
  std::array<int, 2> out{};
  std::array<int, 2> error{};
  const bool hasInput = input == Input::Pipe;
  if (pipe2(out.data(), O_CLOEXEC) != 0 || pipe2(error.data(), O_CLOEXEC) != 0 ||
      (hasInput && pipe2(in.data(), O_CLOEXEC) != 0)) {
    throw std::runtime_error("no pipe");
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (hasInput) {
    posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
  } else {
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  }
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, error[1], STDERR_FILENO);
  auto words = arguments;
  auto variables = withOurs(environment);
  const int failure = posix_spawnp(
      &id_,
      words.front().c_str(),
      &actions,
      nullptr,
      pointersTo(words).data(),
      pointersTo(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (hasInput) close(in[0]);
  close(out[1]);
  close(error[1]);
  in_ = in[1];
  out_ = out[0];
  error_ = error[0];
  if (failure != 0) throw std::runtime_error("could not start " + arguments.front());
}

ChildProcess::~ChildProcess() {
  if (id_ > 0) {
    kill(SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  if (in_ >= 0) close(in_);
  close(out_);
  close(error_);
}

bool ChildProcess::hasEnded() const {
  siginfo_t ended{};
  return waitid(P_PID, static_cast<id_t>(id_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         ended.si_pid == id_;
}

void ChildProcess::say(const std::string& line) const {
  const std::string text = line + "\n";
  if (write(in_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    throw std::runtime_error("nobody listens");
  }
}

bool ChildProcess::readLine(std::string& line) {
  auto end = buffer_.find('\n');
  while (end == std::string::npos && readSome(out_, buffer_)) end = buffer_.find('\n');
  if (end == std::string::npos) return false;
  line = buffer_.substr(0, end);
  buffer_.erase(0, end + 1);
  return true;
}

void ChildProcess::kill(int signal) const {
  ::kill(id_, signal);
}

Finished ChildProcess::finish() {
  Finished finished{.out = std::exchange(buffer_, {})};
  std::array<pollfd, 2> files{pollfd{out_, POLLIN, 0}, pollfd{error_, POLLIN, 0}};
  while (files[0].fd >= 0 || files[1].fd >= 0) {
    if (poll(files.data(), files.size(), -1) < 0) break;
    if (files[0].revents != 0 && !readSome(out_, finished.out)) files[0].fd = -1;
    if (files[1].revents != 0 && !readSome(error_, finished.error)) files[1].fd = -1;
  }
  int status = 0;
  waitpid(std::exchange(id_, -1), &status, 0);
  finished.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return finished;
}

Finished run(
    const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
  return ChildProcess(arguments, environment).finish();
}

bool isInstalled(const std::vector<std::string>& command) {
  try {
    return run(command).status == 0;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace tests
