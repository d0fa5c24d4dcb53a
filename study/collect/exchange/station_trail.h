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

/// Verifies the data that the server has of one station, with the code that verifies a study: the
/// hash chain of the audit trail, its signatures, and all rows and samples against their hashes in
/// the trail. Holders of the station's role and the server's owner can change these data, but
/// cannot sign them.
class StationTrail {
 public:
  /// @param events  all events that the server has of the station
  /// @param keys  content keys of the participants, to open details
  /// @param bundleSignedUpTo  a bundle's signature covers all events up to
  ///     this one
  StationTrail(
      const CollectedStudy::Origin& study,
      const StationRow& station,
      std::vector<storage::StoredEvent> events,
      const std::vector<SentKey>& keys,
      std::int64_t bundleSignedUpTo = 0);

  /// The problems of the trail: an event that differs from its hash, a signature that is invalid or
  /// not of the station's key, a trail that began elsewhere.
  const std::vector<std::string>& problems() const noexcept { return problems_; }

  /// The last event that the station's valid signatures cover, before the first problem. 0: none.
  std::int64_t signedUpTo() const noexcept { return signedUpTo_; }

  /// A message on the events after signedUpTo(); empty: there are none.
  std::string describeUnsignedPart() const;

  /// The last event of each session, as far as it is signed.
  const std::map<std::int64_t, std::int64_t>& lastEvents() const noexcept { return lastEvents_; }

  /// The differences of a session's rows and samples from their hashes in the trail at event @p
  /// lastEvent. Empty: none.
  std::vector<std::string> problemsOf(
      std::int64_t session,
      std::int64_t lastEvent,
      const storage::SessionTables& facts,
      const std::vector<storage::TraceChunk>& chunks);

  /// The key with which the station seals data that reveal which condition was felt.
  const storage::SealingKey& key() const noexcept { return key_; }

  /// The hash of event signedUpTo(), hexadecimal.
  std::string head() const;
  /// Moves the events up to signedUpTo() out; nothing else may be called afterwards.
  std::vector<storage::StoredEvent> takeEvents();

 private:
  void checkTrail(
      const CollectedStudy::Origin& study,
      const StationRow& station,
      std::int64_t bundleSignedUpTo);
  bool agrees(std::int64_t session, const storage::StoredEvent& recorded);
  bool agreesWithNumbers(std::int64_t session, const storage::StoredEvent& recorded);
  struct Trials;
  Trials trialsOf(std::int64_t session) const;
  std::optional<std::string> firstProblemOfTraces(
      std::int64_t session, const std::vector<storage::TraceChunk>& chunks, const Trials& recorded);

  Station station_;
  storage::SealingKey key_;
  std::vector<storage::StoredEvent> events_;
  /// A study with the trail up to signedUpTo() and no sessions. problemsOf() adds one session at a
  /// time, in a transaction that is rolled back.
  std::unique_ptr<storage::Database> database_;
  storage::IdentityStore identities_;
  /// Empty; problemsOf() adds samples in a transaction that is rolled back.
  storage::TraceStore traces_;
  std::vector<std::string> problems_;
  std::int64_t signedUpTo_ = 0;
  std::map<std::int64_t, std::int64_t> lastEvents_;
  std::int64_t versions_ = 1;  ///< number of versions of the protocol at the station
  std::map<std::string, std::int64_t> participants_;  ///< row numbers at the station, by code
  std::map<std::int64_t, std::string> protocols_;     ///< hashes, by row number at the station
};

}  // namespace study::collect
