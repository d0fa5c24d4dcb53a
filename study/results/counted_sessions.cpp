#include "study/results/counted_sessions.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace study {
namespace {

constexpr std::uint32_t kMore = 0x80;  // another byte of this place follows
constexpr unsigned kBits = 7;

}  // namespace

std::deque<CountedSessions::Entry>::iterator CountedSessions::placeOf(SessionId session) {
  if (entries_.empty() || entries_.back().session < session) return entries_.end();
  const auto isBefore = [](const Entry& entry, SessionId wanted) { return entry.session < wanted; };
  return std::lower_bound(entries_.begin(), entries_.end(), session, isBefore);
}

void CountedSessions::put(SessionId session, const std::vector<Place>& places) {
  const auto where = placeOf(session);
  if (where != entries_.end() && where->session == session) {
    throw std::invalid_argument("a session is counted once");
  }
  if (written_.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("more answers than can be counted");
  }
  const auto begin = static_cast<std::uint32_t>(written_.size());
  for (Place place : places) {
    for (; place >= kMore; place >>= kBits) {
      written_.push_back(static_cast<std::uint8_t>(place | kMore));
    }
    written_.push_back(static_cast<std::uint8_t>(place));
  }
  entries_.insert(where, {session, begin, static_cast<std::uint32_t>(places.size())});
}

std::vector<CountedSessions::Place> CountedSessions::take(SessionId session) {
  const auto where = placeOf(session);
  if (where == entries_.end() || where->session != session) return {};
  std::vector<Place> places;
  auto byte = written_.cbegin() + where->begin;
  for (std::uint32_t i = 0; i < where->answers; ++i) {
    Place place = 0;
    unsigned shift = 0;
    for (; (*byte & kMore) != 0; ++byte, shift += kBits) place |= (*byte & ~kMore) << shift;
    places.push_back(place | Place{*byte++} << shift);
  }
  entries_.erase(where);
  return places;
}

}  // namespace study
