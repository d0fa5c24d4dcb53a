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

/// What an audit trail says of its own heads: which were signed, and which were given up when an
/// older copy took its place.
class TrailHeads {
 public:
  explicit TrailHeads(const Database& study);

  struct Signed {
    std::int64_t seq = 0;  ///< of the event that holds it
    SignedHead head;
    bool isSound = false;  ///< the signature, and that it is of the events before it
  };

  const std::vector<Signed>& all() const noexcept { return signed_; }
  std::int64_t lastEvent() const noexcept { return last_; }
  const std::string& study() const noexcept { return study_; }
  const std::string& firstHash() const noexcept { return first_; }

  /// Whether the trail has all events that @p head vouches for, and the event that it was signed
  /// in.
  bool holds(const SignedHead& head) const;

  /// Whether @p head was signed after the trail's last event, as far as that can be seen.
  bool endsBefore(const SignedHead& head) const;

  /// Whether @p head is of the trail that was there before this one was sealed again (event
  /// resealed_trail) or collected, and the station that signed it has signed that, too.
  bool belongsToPreviousTrail(const SignedHead& head) const;

  /// Whether @p head is what a station signed of the trail before when it sealed it again.
  bool isLastOfPreviousTrail(const SignedHead& head) const;

  /// Whether an event that the same station signed says that @p head was given up.
  bool gaveUp(const SignedHead& head) const;

  /// Signatures that are wrong, or not of the events before them. Says how much is signed.
  /// @param key  of this station; empty: it has none
  Findings checkSignatures(const std::string& key) const;

 private:
  std::string hashOf(std::int64_t seq) const;
  void readResealed();
  void readRepeatedErasures();
  void readSigned();
  void readAbandonedHeads();

  const Database& database_;
  std::string study_;
  std::string first_;
  std::int64_t last_ = 0;
  std::int64_t eventsBefore_ = 0;  ///< that were sealed again; they stand behind the first event
  std::string headBefore_;         ///< hash of the last of them, until then
  bool isCollected_ = false;       ///< it repeats the trails of several stations
  /// The last event before a copy was erased from: those after it are not of the study.
  std::int64_t ownEnd_ = 0;
  std::size_t signedBefore_ = 0;  ///< heads among them, which are of another trail
  std::vector<Signed> signed_;
  std::map<std::string, std::set<std::string>> givenUp_;  ///< by key
};

/// How heads that were given up are named in the event RestoredCopy.
std::string nameOf(const SignedHead& head);

}  // namespace study::storage
