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

/// The signed heads in an audit trail, and the heads that were given up when an older copy replaced
/// the study.
class TrailHeads {
 public:
  explicit TrailHeads(const Database& study);

  /// A signed head in the trail.
  struct Signed {
    std::int64_t seq = 0;  ///< number of the event that contains the head
    SignedHead head;
    bool isSound = false;  ///< whether the signature is valid and covers the events before it
  };

  const std::vector<Signed>& all() const noexcept { return signed_; }
  std::int64_t lastEvent() const noexcept { return lastEvent_; }  ///< number of the last event
  /// Number of the last event before the first erasure that was repeated in this copy only.
  std::int64_t lastSharedEvent() const noexcept { return lastSharedEvent_; }
  const std::string& study() const noexcept { return study_; }          ///< uuid
  const std::string& firstHash() const noexcept { return firstHash_; }  ///< hash of the first event

  /// Whether the trail has the events up to @p head unchanged, and the event that contains @p head.
  bool holds(const SignedHead& head) const;

  /// Whether @p head was signed after the trail's last event, judged by its number of events.
  bool endsBefore(const SignedHead& head) const;

  /// Whether @p head belongs to the trail before it was sealed again (event ResealedTrail) or
  /// collected, and its station also signed that event.
  bool belongsToPreviousTrail(const SignedHead& head) const;

  /// Whether @p head is the last head of the previous trail, signed just before it was sealed
  /// again.
  bool isLastOfPreviousTrail(const SignedHead& head) const;

  /// Whether an event RestoredCopy lists @p head as given up, and the station of @p head signed
  /// this event.
  bool isAbandoned(const SignedHead& head) const;

  /// Reports signatures that are invalid or do not cover the events before them; remarks state how
  /// many events are signed.
  /// @param key  public key of this station; empty if the station has none
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
  std::string firstHash_;
  std::int64_t lastEvent_ = 0;
  /// Number of events of the previous trail that follow the first event; 0 if there is no previous
  /// trail.
  std::int64_t previousTrailEvents_ = 0;
  std::string previousTrailHead_;  ///< hash of the last event of the previous trail
  bool isCollected_ = false;       ///< whether the trail consists of the trails of several stations
  /// Number of the last event that all copies of the study have in common: the one before the first
  /// erasure that was repeated in this copy only.
  std::int64_t lastSharedEvent_ = 0;
  std::size_t previousTrailHeads_ = 0;  ///< number of signed heads among previousTrailEvents_
  std::vector<Signed> signed_;
  /// nameOf() of the heads that were given up, by the public key of the station.
  std::map<std::string, std::set<std::string>> abandonedHeads_;
};

/// The text that refers to a head in the event RestoredCopy: "812:1a2b3c4d…".
std::string nameOf(const SignedHead& head);

}  // namespace study::storage
