#include "study/bench/bench_workers.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

#include "study/model/user_error.h"

extern char** environ;

namespace study::app {
namespace {

struct Actions {
  posix_spawn_file_actions_t value{};
  Actions() { posix_spawn_file_actions_init(&value); }
  ~Actions() { posix_spawn_file_actions_destroy(&value); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
};

using Line = std::function<void(const std::string&)>;

void handOnLines(FILE* output, const Line& line) {
  char* text = nullptr;
  std::size_t size = 0;
  while (true) {
    const ssize_t length = getline(&text, &size, output);
    if (length < 0) break;
    const bool hasEnd = length > 0 && text[length - 1] == '\n';
    line(std::string(text, static_cast<std::size_t>(hasEnd ? length - 1 : length)));
  }
  free(text);
}

/// @return the exit status; nothing where it could not be started, or a signal ended it.
std::optional<int> runAndRead(
    const char* file,
    const std::string& name,
    std::vector<std::string> arguments,
    const Line& line) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw UserError("Another process cannot be started: no pipe.");
  const std::unique_ptr<FILE, int (*)(FILE*)> output(fdopen(ends[0], "r"), fclose);

  arguments.insert(arguments.begin(), name);
  std::vector<char*> words;
  for (auto& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  Actions actions;
  posix_spawn_file_actions_adddup2(&actions.value, ends[1], STDOUT_FILENO);
  pid_t child = -1;
  const int failed = posix_spawnp(&child, file, &actions.value, nullptr, words.data(), environ);
  close(ends[1]);
  if (failed != 0) return std::nullopt;

  handOnLines(output.get(), line);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? std::optional(WEXITSTATUS(status)) : std::nullopt;
}

}  // namespace

void runAnotherOfUs(const std::vector<std::string>& arguments, const Line& line) {
  if (runAndRead("/proc/self/exe", "palpate", arguments, line) == 0) return;
  throw UserError("A process that measured did not end well; what it measured is incomplete.");
}

std::optional<int> runProgram(
    const std::string& program, const std::vector<std::string>& arguments, const Line& line) {
  return runAndRead(program.c_str(), program, arguments, line);
}

}  // namespace study::app
