#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "base/user_error.h"

namespace questionnaires {

/// The severity of a problem in a file.
enum class Severity {
  Error,    ///< the file cannot be used
  Warning,  ///< the file can be used, but its author should know
};

/// Something wrong or doubtful in a researcher's file, and advice on it. Errors are in English, for
/// the researcher; warnings are also part of reports and are translated by key.
struct Problem {
  Severity severity = Severity::Error;
  std::string path;              ///< JSON path from the root: "$.phases[3].order"
  base::Message what;            ///< what is wrong
  base::Message fix;             ///< advice; may be empty
  std::optional<int> line = {};  ///< line of a JSON syntax error, from 0
};

/// The largest number of problems that are kept. If there are more, one further problem says so.
inline constexpr std::size_t kMostProblems = 1000;

/// The problems of a file. Reading collects all of them, so that the author sees them at once.
class Problems {
 public:
  void add(std::string path, std::string what, std::string fix = {}) {
    using base::Message;
    add(
        {Severity::Error,
         std::move(path),
         Message::verbatim(std::move(what)),
         Message::verbatim(std::move(fix))});
  }
  void warn(std::string path, base::Message what, base::Message fix = {}) {
    add({Severity::Warning, std::move(path), std::move(what), std::move(fix)});
  }
  void add(Problem problem);
  void append(const Problems& others) {
    for (const auto& problem : others.list_) add(problem);
  }

  const std::vector<Problem>& all() const& noexcept { return list_; }
  std::vector<Problem> all() && noexcept { return std::move(list_); }  // outlives problemsOf(x)
  bool hasErrors() const noexcept { return hasErrors_; }

 private:
  std::vector<Problem> list_;
  bool hasErrors_ = false;
};

/// The problems as text for a terminal, one per line.
std::string describe(const std::vector<Problem>& problems);

}  // namespace questionnaires
