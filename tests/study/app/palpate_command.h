#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/scratch_folder.h"

namespace tests {

using Words = std::vector<std::string>;

/// The exit status if a study or a file does not allow what was asked for.
inline constexpr int kTheWorldSaidNo = 1;
/// The exit status of a call with a mistake.
inline constexpr int kTheCallIsWrong = 2;

/// Runs palpate with @p arguments.
Finished palpate(Words arguments);

/// The call as it is typed: "palpate study status".
std::string describe(const Words& arguments);

Words linesOf(const std::string& text);

/// Expects that the call fails with @p status, prints nothing but an error, and has all @p phrases
/// in that.
void expectRefused(const Words& arguments, int status, const Words& phrases);

/// A folder, and a study in it that the commands make.
class StudyOfCommands : public testing::Test {
 protected:
  /// The folder of a new study with @p participants simulated people.
  std::string made(const std::string& protocol, int participants = 0);

  ScratchFolder folder_;
};

}  // namespace tests
