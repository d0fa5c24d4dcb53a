#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace haptics::emulators {

/// A pseudo-terminal: the program that opens port() reads what write() sent, and vice versa.
class PseudoTerminal {
 public:
  /// @param link  path of a symbolic link to the port, which stays the same after plugIn(); empty:
  ///              no link.
  /// @throws std::runtime_error  if no pseudo-terminal is available, or the link cannot be created.
  explicit PseudoTerminal(std::string link = {});
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// The path to open: the link if there is one.
  const std::string& port() const noexcept { return link_.empty() ? systemName_ : link_; }

  /// unplug() simulates that the cable is pulled out, plugIn() that it is plugged in again; the
  /// system then gives the port another name.
  void unplug() noexcept;
  void plugIn();
  bool isPlugged() const noexcept { return master_ >= 0; }

  /// Reads the available bytes and returns their number.
  std::size_t read(std::span<std::uint8_t> into) noexcept;
  /// Writes all bytes, or none if the terminal's buffer is almost full; they are then lost, as on a
  /// serial line.
  void write(std::span<const std::uint8_t> bytes) noexcept;

 private:
  void requireUnusedLink();
  void removeLink() noexcept;

  std::string link_;
  std::string systemName_;
  int master_ = -1;
};

}  // namespace haptics::emulators
