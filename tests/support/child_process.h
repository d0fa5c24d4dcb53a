#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace tests {

/// What a program came to.
struct Finished {
  int status = 0;  ///< its exit status; −signal where one ended it
  std::string out;
  std::string error;
};

/// A program that a test runs; gone with it.
class ChildProcess {
 public:
  enum class Input { None, Pipe };

  /// @param arguments  the program first. @param environment  "NAME=value", besides our own.
  /// @param input  with a pipe, say() reaches it.
  explicit ChildProcess(
      const std::vector<std::string>& arguments,
      const std::vector<std::string>& environment = {},
      Input input = Input::None);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t id() const noexcept { return id_; }
  /// Whether it has come to its end by itself; what it wrote can still be read.
  bool hasEnded() const;

  /// The next line of its output, without its end; false where there is none any more.
  bool readLine(std::string& line);
  /// A line for its input.
  void say(const std::string& line) const;
  void kill(int signal) const;
  /// Reads everything that is left, and waits for its end.
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

}  // namespace tests
