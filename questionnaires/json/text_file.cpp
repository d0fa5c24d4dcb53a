#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "questionnaires/json/document.h"

namespace questionnaires {

std::string readTextFile(const std::string& path, std::size_t most) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw Error("There is no file " + path + ". Check the spelling and the folder.");
  }
  if (status.type() != fs::file_type::regular) {
    throw Error(path + " is not a file that can be read. Give the name of a text file.");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw Error(
        path + " cannot be opened (" + std::generic_category().message(errno) +
        "). Check who may read it.");
  }
  if (fs::file_size(path, error) > most) {
    throw Error(
        path + " is larger than " + std::to_string(most / 1'000'000) +
        " MB. No researcher's file needs that; is it the right file?");
  }
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) throw Error(path + " could not be read to its end. Is the disk healthy?");
  return text;
}

}  // namespace questionnaires
