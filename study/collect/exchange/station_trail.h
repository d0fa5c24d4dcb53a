#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/collect/exchange/batch.h"
#include "study/collect/exchange/server_reader.h"
#include "study/session/collected_study.h"
#include "study/storage/database.h"
#include "study/storage/event_log.h"
#include "study/storage/identity_store.h"
#include "study/storage/trace_store.h"

namespace study::collect {

/// What the server has of one station, checked by the code that verifies a study: the chain of its
/// audit trail, its signatures, and all rows and samples against the hashes that the trail has of
/// them. A person with the station's role, or the server's owner, can change what is there, but
/// cannot sign it.
class StationTrail {
 public:
  /// @param events  all that the server has
  /// @param keys  with which the trail says what it says of people
  /// @param vouchedUpTo  the station signed everything up to this event in another way, too
  StationTrail(
      const CollectedStudy::Origin& study,
      const StationRow& station,
      std::vector<storage::StoredEvent> events,
      const std::vector<SentKey>& keys,
      std::int64_t vouchedUpTo = 0);

  /// What is wrong: an event that is not of its hash, a signature that is not of the events before
  /// it or of another key than the station's, a trail that began elsewhere. Empty: nothing.
  const std::vector<std::string>& problems() const noexcept { return problems_; }

  /// Everything up to this event is vouched for by the station's key: its last signature before
  /// anything that is wrong. 0: nothing is.
  std::int64_t signedUpTo() const noexcept { return signedUpTo_; }

  /// Which events after that there are, in words; empty: none.
  std::string unsignedPart() const;

  /// The last event of each session, as far as it is signed.
  const std::map<std::int64_t, std::int64_t>& lastEvents() const noexcept { return lastEvents_; }

  /// What of a session differs from what the trail says after its event @p asOf. Empty: nothing.
  std::vector<std::string> problemsOf(
      std::int64_t session,
      std::int64_t asOf,
      const storage::SessionFacts& facts,
      const std::vector<storage::TraceChunk>& chunks);

  /// With which the station seals what tells which condition was felt.
  const storage::SealingKey& key() const noexcept { return key_; }

  /// The hash of event signedUpTo(), hexadecimal.
  std::string head() const;
  /// Ends this: the events up to signedUpTo().
  std::vector<storage::StoredEvent> takeEvents();

 private:
  void judge(
      const CollectedStudy::Origin& study, const StationRow& station, std::int64_t vouchedUpTo);
  bool agrees(std::int64_t session, const storage::StoredEvent& said);
  bool agreesWithNumbers(std::int64_t session, const storage::StoredEvent& said);
  struct Trials;
  Trials trialsOf(std::int64_t session) const;
  std::optional<std::string> firstProblemOfTraces(
      std::int64_t session, const std::vector<storage::TraceChunk>& chunks, const Trials& said);

  Station station_;
  storage::SealingKey key_;
  std::vector<storage::StoredEvent> events_;
  /// A study without sessions, which has the trail up to signedUpTo(). Sessions are put into it one
  /// at a time.
  std::unique_ptr<storage::Database> database_;
  storage::IdentityStore identities_;
  storage::TraceStore traces_;  ///< empty: samples of a session are put into it, and taken out
  std::vector<std::string> problems_;
  std::int64_t signedUpTo_ = 0;
  std::map<std::int64_t, std::int64_t> lastEvents_;
  std::int64_t versions_ = 1;                         ///< of the protocol that the station had
  std::map<std::string, std::int64_t> participants_;  ///< their rows at the station, by code
  std::map<std::int64_t, std::string> protocols_;     ///< hashes, by their rows at the station
};

}  // namespace study::collect
