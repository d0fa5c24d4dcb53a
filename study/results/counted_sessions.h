#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "study/model/ids.h"

namespace study {

/// What each session has added to some counts, so that it can be taken back: for every answer the
/// place of the count that it was added to.
///
/// A place below 128 takes one byte, a session sixteen: ten million answers of half a million
/// people fit into 20 MB.
class CountedSessions {
 public:
  using Place = std::uint32_t;

  /// @p session has added to @p places. It is not there yet.
  /// @throws std::invalid_argument  if it is.
  void put(SessionId session, const std::vector<Place>& places);

  /// What it has added to, which is forgotten; nothing where it is not there.
  std::vector<Place> take(SessionId session);

 private:
  struct Entry {
    SessionId session{};
    std::uint32_t begin = 0;
    std::uint32_t answers = 0;
  };

  std::deque<Entry>::iterator placeOf(SessionId session);

  std::deque<Entry> entries_;         ///< by session
  std::deque<std::uint8_t> written_;  ///< seven bits of a place at a time, low ones first
};

}  // namespace study
