#pragma once

#include <compare>
#include <cstdint>

namespace study {

/// Ids have their own types, so that a session is not taken for a participant.
enum class SessionId : std::int64_t {};
enum class ParticipantId : std::int64_t {};
enum class ProtocolId : std::int64_t {};

/// One visit to one step. A repeated step gets a new attempt; nothing is overwritten.
struct VisitKey {
  SessionId session{};
  int step = 0;     ///< from 0
  int attempt = 1;  ///< from 1

  auto operator<=>(const VisitKey&) const = default;
};

}  // namespace study
