#include "tests/study/app/palpate_command.h"

#include <sstream>

#include "tests/support/programs.h"

namespace tests {

Finished palpate(Words arguments) {
  arguments.insert(arguments.begin(), program());
  return run(arguments);
}

std::string describe(const Words& arguments) {
  std::string text = "palpate";
  for (const auto& argument : arguments) text += " " + argument;
  return text;
}

Words linesOf(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void expectRefused(const Words& arguments, int status, const Words& phrases) {
  SCOPED_TRACE(describe(arguments));
  const auto finished = palpate(arguments);
  EXPECT_EQ(finished.status, status) << finished.error;
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.error.rfind("palpate: ", 0), 0U) << finished.error;
  for (const auto& phrase : phrases) {
    EXPECT_NE(finished.error.find(phrase), std::string::npos) << finished.error;
  }
}

std::string StudyOfCommands::made(const std::string& protocol, int participants) {
  const std::string folder = folder_ / "study";
  EXPECT_EQ(palpate({"study", "create", folder, "--protocol", protocol, "--seed", "7"}).status, 0);
  if (participants > 0) {
    EXPECT_EQ(
        palpate({"study", "simulate", folder, "--participants", std::to_string(participants)})
            .status,
        0);
  }
  return folder;
}

}  // namespace tests
