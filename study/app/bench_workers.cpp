#include "study/app/bench_workers.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

#include "study/session.h"

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

}  // namespace

void runAnotherOfUs(
    const std::vector<std::string>& arguments,
    const std::function<void(const std::string&)>& line) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw NotNow("Another process cannot be started: no pipe.");
  const std::unique_ptr<FILE, int (*)(FILE*)> output(fdopen(ends[0], "r"), fclose);

  std::vector<char*> words;
  std::string name = "palpate";
  words.push_back(name.data());
  auto copies = arguments;
  for (auto& argument : copies) words.push_back(argument.data());
  words.push_back(nullptr);
  Actions actions;
  posix_spawn_file_actions_adddup2(&actions.value, ends[1], STDOUT_FILENO);
  pid_t child = -1;
  const int failed =
      posix_spawn(&child, "/proc/self/exe", &actions.value, nullptr, words.data(), environ);
  close(ends[1]);
  if (failed != 0) throw NotNow("Another process of this program cannot be started.");

  char* text = nullptr;
  std::size_t size = 0;
  while (true) {
    const ssize_t length = getline(&text, &size, output.get());
    if (length < 0) break;
    const bool hasEnd = length > 0 && text[length - 1] == '\n';
    line(std::string(text, static_cast<std::size_t>(hasEnd ? length - 1 : length)));
  }
  free(text);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw NotNow("A process that measured did not end well; what it measured is incomplete.");
  }
}

}  // namespace study::app
