#include "study/app/printing/visible_output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>

#include <fmt/format.h>

#include "questionnaires/json/document.h"

namespace study::app {
namespace {

/// The result of decoding the first character of a text.
struct Decoded {
  enum class State { Valid, Unfinished, NotUtf8 };
  State state = State::NotUtf8;
  std::uint32_t code = 0;
  std::size_t bytes = 1;
};

/// The number of bytes of a UTF-8 character with the first byte @p lead; 0 if that is no first
/// byte.
std::size_t characterSize(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  return lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
}

Decoded decodeFirst(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t bytes = characterSize(lead);
  if (bytes == 0) return {};
  if (bytes == 1) return {Decoded::State::Valid, lead, 1};
  std::uint32_t code = lead & (0xffU >> (bytes + 1));
  for (const char c : text.substr(1, bytes - 1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0U) != 0x80) return {};
    code = code << 6 | (byte & 0x3fU);
  }
  if (text.size() < bytes) return {.state = Decoded::State::Unfinished};
  // an overlong encoding or a surrogate
  if (!questionnaires::utf8CharacterCount(text.substr(0, bytes))) return {};
  return {Decoded::State::Valid, code, bytes};
}

bool isTerminalControl(std::uint32_t code) {
  const bool isControl = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool reversesText =
      (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return (isControl && code != '\n' && code != '\t') || reversesText;
}

/// stdout or stderr.
struct Output {
  int file = -1;
  VisibleText visible;
};

bool writeAll(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// The write function of the stream (fopencookie(3)); returns 0 after an error.
ssize_t writeVisibly(void* cookie, const char* text, std::size_t count) {
  auto& output = *static_cast<Output*>(cookie);
  const bool isWritten = writeAll(output.file, output.visible({text, count}));
  return isWritten ? static_cast<ssize_t>(count) : 0;
}

/// A stream that escapes text and writes it to @p output; @p fallback if it cannot be created.
FILE* openEscapingStream(Output& output, FILE* fallback, int buffering) {
  FILE* stream = fopencookie(&output, "w", {nullptr, writeVisibly, nullptr, nullptr});
  if (stream == nullptr) return fallback;
  std::fflush(fallback);
  std::setvbuf(stream, nullptr, buffering, BUFSIZ);
  return stream;
}

}  // namespace

std::string VisibleText::operator()(std::string_view part) {
  pending_ += part;
  std::string_view text = pending_;
  std::string shown;
  while (!text.empty()) {
    const auto next = decodeFirst(text);
    const bool isUnfinished = next.state == Decoded::State::Unfinished || text == "\r";
    if (isUnfinished) break;
    const bool endsLine = text.substr(0, 2) == "\r\n";
    if (next.state == Decoded::State::NotUtf8) {
      shown += "\xef\xbf\xbd";
    } else if (isTerminalControl(next.code) && !endsLine) {
      shown += fmt::format("\\u{:04x}", next.code);
    } else {
      shown += text.substr(0, next.bytes);
    }
    text.remove_prefix(next.bytes);
  }
  pending_ = std::string(text);
  return shown;
}

void escapeControlCharactersInOutput() {
  static Output out{STDOUT_FILENO, {}};
  static Output error{STDERR_FILENO, {}};
  static const bool isDone = [] {
    stdout = openEscapingStream(out, stdout, isatty(STDOUT_FILENO) != 0 ? _IOLBF : _IOFBF);
    stderr = openEscapingStream(error, stderr, _IONBF);
    return true;
  }();
  static_cast<void>(isDone);
}

}  // namespace study::app
