#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace tests {

/// The result of a program.
struct Finished {
  int status = 0;  ///< exit status; −signal if a signal ended it
  std::string out;
  std::string error;
};

/// A program started by a test; the destructor ends it.
class ChildProcess {
 public:
  enum class Input { None, Pipe };

  /// @param arguments  the program first.
  /// @param environment  "NAME=value", in addition to ours.
  /// @param input  with a pipe for say().
  explicit ChildProcess(
      const std::vector<std::string>& arguments,
      const std::vector<std::string>& environment = {},
      Input input = Input::None);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t id() const noexcept { return id_; }
  /// Whether it has ended by itself; its output can still be read.
  bool hasEnded() const;

  /// The next line of its output, without line feed; false if there is none left.
  bool readLine(std::string& line);
  /// Writes a line to its input.
  void say(const std::string& line) const;
  void kill(int signal) const;
  /// Reads the remaining output and waits for the end.
  Finished finish();

 private:
  pid_t id_ = -1;
  int in_ = -1;
  int out_ = -1;
  int error_ = -1;
  std::string buffer_;
};

Finished run(
    const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {});

/// Whether @p command can be started and succeeds: {"Rscript", "-e", "0"}.
bool isInstalled(const std::vector<std::string>& command);

}  // namespace tests
