#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "study/storage/database.h"
#include "study/storage/evidence/findings.h"
#include "study/storage/evidence/signed_head.h"

namespace study::storage {

/// The signed heads in an audit trail, and the heads that were given up when an older copy took the
/// study's place.
class TrailHeads {
 public:
  explicit TrailHeads(const Database& study);

  struct Signed {
    std::int64_t seq = 0;  ///< number of the event that holds it
    SignedHead head;
    bool isSound = false;  ///< the signature is valid and is of the events before it
  };

  const std::vector<Signed>& all() const noexcept { return signed_; }
  std::int64_t lastEvent() const noexcept { return last_; }         ///< its number
  const std::string& study() const noexcept { return study_; }      ///< uuid
  const std::string& firstHash() const noexcept { return first_; }  ///< hash of the first event

  /// Whether the trail has all events that @p head vouches for, and the event that holds this head.
  bool holds(const SignedHead& head) const;

  /// Whether @p head was signed after the trail's last event, judging by its number of events.
  bool endsBefore(const SignedHead& head) const;

  /// Whether @p head belongs to the trail before it was sealed again (event resealed_trail) or
  /// collected, and the same station signed that event, too.
  bool belongsToPreviousTrail(const SignedHead& head) const;

  /// Whether @p head is the last head of the previous trail, signed just before that was sealed
  /// again.
  bool isLastOfPreviousTrail(const SignedHead& head) const;

  /// Whether an event RestoredCopy lists @p head as given up, and the station of @p head signed
  /// that event.
  bool isGivenUp(const SignedHead& head) const;

  /// Reports signatures that are invalid or not of the events before them; remarks say how much is
  /// signed.
  /// @param key  public key of this station; empty: it has none
  Findings checkSignatures(const std::string& key) const;

 private:
  /// The hash of event number @p seq; empty if there is none.
  std::string hashOf(std::int64_t seq) const;
  void readResealed();
  void readRepeatedErasures();
  void readSigned();
  void readAbandonedHeads();

  const Database& database_;
  std::string study_;
  std::string first_;
  std::int64_t last_ = 0;
  /// Events of the previous trail that follow the first event; 0: none.
  std::int64_t previousTrailEvents_ = 0;
  std::string previousTrailHead_;  ///< hash of the last event of the previous trail
  bool isCollected_ = false;       ///< it repeats the trails of several stations
  /// Number of the last event before the first erasure that was repeated in this copy of the study
  /// only: up to there, all copies have the same events.
  std::int64_t lastSharedEvent_ = 0;
  std::size_t previousTrailHeads_ = 0;  ///< signed heads among previousTrailEvents_
  std::vector<Signed> signed_;
  /// Names of heads that were given up (nameOf()), by the public key of the station.
  std::map<std::string, std::set<std::string>> givenUp_;
};

/// The text by which the event RestoredCopy refers to a head: "812:1a2b3c4d…".
std::string nameOf(const SignedHead& head);

}  // namespace study::storage
