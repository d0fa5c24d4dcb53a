#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace study {

/// Each kind of id has its own type, so that the compiler rejects one in place of another.
enum class SessionId : std::int64_t {};
enum class ProtocolId : std::int64_t {};

/// One visit to one step. A repeated step gets a new attempt; nothing is overwritten.
struct VisitKey {
  SessionId session{};
  int step = 0;     ///< from 0
  int attempt = 1;  ///< from 1

  auto operator<=>(const VisitKey&) const = default;
};

/// Where a session takes place: one computer at one of the sites of a study. All empty in a study
/// of one machine.
struct Station {
  std::string site;   ///< "oslo"
  std::string label;  ///< "oslo", "oslo-2": unique in the study; participants' codes begin with it
  std::string uuid;   ///< drawn when the station was enrolled

  bool isNone() const noexcept { return label.empty(); }
};

}  // namespace study
