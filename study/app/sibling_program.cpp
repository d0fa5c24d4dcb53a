#include "study/app/sibling_program.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "study/model/user_error.h"

namespace study::app {

std::string siblingProgram(const std::string& name) {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

void replaceProcessBy(const std::string& name, const std::vector<std::string>& arguments) {
  const auto program = siblingProgram(name);
  auto texts = arguments;
  texts.insert(texts.begin(), name);
  std::vector<char*> words;
  for (auto& text : texts) words.push_back(text.data());
  words.push_back(nullptr);
  execv(program.c_str(), words.data());
  throw UserError(
      program + " cannot be started: " + std::strerror(errno) +
      ". It is installed together with this program.");
}

}  // namespace study::app
