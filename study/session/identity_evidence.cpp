#include "study/session/identity_evidence.h"

#include <map>
#include <set>
#include <sstream>

#include "study/storage/evidence/identity_rows.h"
#include "study/storage/stored_values.h"

namespace study {
namespace {

using storage::Findings;

constexpr const char* kNoRow = "-";
constexpr const char* kUnknown = "";  ///< the event is of a release without fingerprints

/// The rows that identity.db must have according to the audit trail: their fingerprints, by the
/// names of the rows.
class ExpectedIdentities {
 public:
  explicit ExpectedIdentities(Study& study) {
    for (const auto& row : study.sessions().all()) sessions_[row.id] = row;
    for (const auto& event : study.events().read()) add(event);
  }

  const std::map<std::string, std::string>& rows() const noexcept { return rows_; }

  bool isErased(const std::string& row) const {
    return erased_.count(row.substr(0, row.find('/'))) > 0;
  }

  /// Whether the row belongs to the present step of an unfinished session. Differences of such rows
  /// are noted when the session is resumed.
  bool isInPresentStep(const std::string& row) const {
    for (const auto& [id, session] : sessions_) {
      if (isOver(session.state)) continue;
      const storage::IdentityStore::Place place{
          session.participant, session.number, session.step, session.attempt};
      if (row.starts_with(place.rowOf(""))) return true;
    }
    return false;
  }

 private:
  void add(const storage::Event& event) {
    if (event.kind == EventKind::NotedIdentities) {
      std::istringstream pairs(storage::storedText(event.values, "rows"));
      for (std::string pair; pairs >> pair;) {
        const auto sign = pair.find('=');
        if (sign != std::string::npos) rows_[pair.substr(0, sign)] = pair.substr(sign + 1);
      }
    } else if (
        event.name() == "erased" && storage::storedText(event.values, "level") != "answers") {
      erased_.insert(storage::storedText(event.values, "participant"));
    } else if (event.visit && sessions_.count(event.visit->session) > 0) {
      addSessionEvent(event);
    }
  }

  void addSessionEvent(const storage::Event& event) {
    const auto& session = sessions_.at(event.visit->session);
    const auto nameFor = [&](const std::string& item) {
      const storage::IdentityStore::Place place{
          session.participant, session.number, event.visit->step, event.visit->attempt};
      return place.rowOf(item);
    };
    if (event.kind == EventKind::Retracted) rows_.erase(nameFor(event.detail));
    if (event.kind != EventKind::Answered || event.value("kept_apart") == nullptr) return;
    rows_[nameFor(storage::storedText(event.values, "item"))] =
        storage::storedText(event.values, "fingerprint");
  }

  std::map<SessionId, storage::SessionRow> sessions_;
  std::map<std::string, std::string> rows_;
  std::set<std::string> erased_;
};

/// The fingerprints of the rows of identity.db, by name.
std::map<std::string, std::string> presentRows(Study& study) {
  const auto secret = study.fingerprintSecret();
  std::map<std::string, std::string> rows;
  for (const auto& row : storage::identityRows(study.identities().database())) {
    rows[row.name] = secret ? secret->fingerprint(row.bytes) : kUnknown;
  }
  return rows;
}

void compare(
    const std::string& row,
    const std::string& expected,
    const std::map<std::string, std::string>& present,
    Findings& findings) {
  const auto here = present.find(row);
  if (expected == kNoRow ? here != present.end() : here == present.end()) {
    findings.problems.push_back(
        "what names " + row + (expected == kNoRow ? " was gone, and is there" : " is missing"));
  } else if (expected != kNoRow && expected != kUnknown && here->second != expected) {
    findings.problems.push_back("what names " + row + " is not what the audit trail says");
  }
}

/// Appends to the trail the fingerprints of rows that differ from it and whose names begin with
/// @p prefix.
void noteRows(Study& study, const std::string& prefix) {
  if (!study.fingerprintSecret()) return;
  const auto present = presentRows(study);
  const ExpectedIdentities expected(study);
  std::string pairs;
  const auto add = [&](const std::string& row, const std::string& fingerprint) {
    if (row.starts_with(prefix)) pairs += (pairs.empty() ? "" : " ") + row + "=" + fingerprint;
  };
  for (const auto& [row, fingerprint] : present) {
    const auto known = expected.rows().find(row);
    const bool isKnown = known != expected.rows().end() &&
                         (known->second == fingerprint || known->second == kUnknown);
    if (!isKnown) add(row, fingerprint);
  }
  for (const auto& [row, fingerprint] : expected.rows()) {
    if (present.count(row) == 0 && fingerprint != kNoRow) add(row, kNoRow);
  }
  if (!pairs.empty()) {
    study.note({.kind = EventKind::NotedIdentities, .values = {{"rows", pairs}}});
  }
}

}  // namespace

std::string fingerprintOf(
    Study& study, const storage::IdentityStore::Place& place, const std::string& item) {
  const auto rows = presentRows(study);
  const auto found = rows.find(place.rowOf(item));
  return found == rows.end() ? std::string() : found->second;
}

void recordIdentityFingerprints(Study& study, const storage::SessionRow& session) {
  if (isOver(session.state)) return;
  const storage::IdentityStore::Place place{
      session.participant, session.number, session.step, session.attempt};
  noteRows(study, place.rowOf(""));
}

void removeNames(Study& study, const storage::SessionRow& session) {
  study.retryWithReservedSpace(
      [&] { study.identities().removeSession(session.participant, session.number); });
  noteRows(study, session.participant + "/" + std::to_string(session.number) + "/");
}

std::string fingerprintsOf(Study& study, const std::string& participant) {
  std::string pairs;
  for (const auto& [row, fingerprint] : presentRows(study)) {
    if (!row.starts_with(participant + "/")) continue;
    pairs += (pairs.empty() ? "" : " ") + row + "=" + fingerprint;
  }
  return pairs;
}

void recordFingerprintsOfSealedRows(Study& study) {
  const auto secret = study.fingerprintSecret();
  if (!secret) return;
  const auto present = presentRows(study);
  const ExpectedIdentities expected(study);
  std::string pairs;
  for (const auto& before : storage::identityRowsBeforeSealing(study.identities())) {
    const auto known = expected.rows().find(before.name);
    if (known == expected.rows().end() || known->second != secret->fingerprint(before.bytes))
      continue;
    pairs += (pairs.empty() ? "" : " ") + before.name + "=" + present.at(before.name);
  }
  if (!pairs.empty()) {
    study.note({.kind = EventKind::NotedIdentities, .values = {{"rows", pairs}}});
  }
}

storage::Findings checkIdentities(Study& study) {
  Findings findings;
  const auto present = presentRows(study);
  const ExpectedIdentities expected(study);
  std::size_t unknown = 0;
  for (const auto& [row, fingerprint] : expected.rows()) {
    if (expected.isErased(row) || expected.isInPresentStep(row)) continue;
    compare(row, fingerprint, present, findings);
    if (fingerprint == kUnknown) ++unknown;
  }
  for (const auto& [row, fingerprint] : present) {
    if (expected.rows().count(row) > 0 || expected.isInPresentStep(row)) continue;
    if (fingerprint == kUnknown) {
      ++unknown;
    } else {
      findings.problems.push_back("what names " + row + " was never answered");
    }
  }
  if (unknown > 0) {
    findings.remarks.push_back(
        std::to_string(unknown) +
        " of the answers that name people were written by an older release: that they are there is "
        "checked, and not what they say");
  }
  return findings;
}

}  // namespace study
