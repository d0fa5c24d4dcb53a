#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace haptics::emulators {

/// A pseudo-terminal: what is written here is read by the program that opens port().
class PseudoTerminal {
 public:
  /// @param link  a link to the port that stays when it is plugged in again; empty: none.
  /// @throws std::runtime_error  where the system gives none, or the link cannot be made.
  explicit PseudoTerminal(std::string link = {});
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// What to open: the link if there is one.
  const std::string& port() const noexcept { return link_.empty() ? name_ : link_; }

  /// Simulates that the cable is pulled out and plugged in again; the system then gives the port
  /// another name.
  void unplug() noexcept;
  void plugIn();
  bool isPlugged() const noexcept { return master_ >= 0; }

  /// What has come; 0 for nothing.
  std::size_t read(std::span<std::uint8_t> into) noexcept;
  /// As much as there is room for; the rest is lost, as on a line.
  void write(std::span<const std::uint8_t> bytes) noexcept;

 private:
  void requireFreeName();
  void removeLink() noexcept;

  std::string link_;
  std::string name_;
  int master_ = -1;
};

}  // namespace haptics::emulators
