#include "haptics/recordings/recording_file.h"

#include <fstream>
#include <string>
#include <system_error>

#include "haptics/recordings/error.h"
#include "haptics/recordings/recording_text.h"

namespace haptics::recordings {
namespace {

namespace fs = std::filesystem;

void requirePlainFile(const fs::path& path) {
  const std::string name = "'" + path.string() + "'";
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw Error("There is no recording " + name + ": check the name and the folder.");
  }
  if (error) throw Error("The recording " + name + " cannot be reached: " + error.message() + ".");
  if (fs::is_directory(status)) {
    throw Error(name + " is a folder: name one recording in it, a .txt file.");
  }
  if (!fs::is_regular_file(status)) {
    throw Error(name + " is no plain file: copy the recording into one first.");
  }
}

void requireModestSize(const fs::path& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size <= kLargestRecording) return;
  throw Error(
      "'" + path.string() + "' is larger than 200 MB (" + std::to_string(size / 1'000'000) +
      " MB): a recording of the punch has about 1 MB a minute; check that it is one.");
}

}  // namespace

Recording readRecordingFile(const fs::path& path) {
  requirePlainFile(path);
  requireModestSize(path);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw Error("'" + path.string() + "' cannot be opened: check that you may read it.");
  }
  std::error_code error;
  std::string text(static_cast<std::size_t>(fs::file_size(path, error)), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (error || stream.bad()) {
    throw Error("'" + path.string() + "' could not be read to its end: copy it and try again.");
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return readRecording(text, path.filename().string());
}

}  // namespace haptics::recordings
