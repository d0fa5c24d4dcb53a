#pragma once

#include <string>

#include "study/session/study.h"
#include "study/storage/evidence/findings.h"

namespace study {

/// A fingerprint for the audit trail: a keyed hash of a row of identity.db. It changes with the
/// row, and reveals nothing without the study's secret. Empty if there is no such row, or if the
/// study has no secret.
std::string fingerprintOf(
    Study& study, const storage::IdentityStore::Place& place, const std::string& item);

/// Notes in the audit trail how identity.db differs from the trail in the present step of a
/// session. The trail is in another file, so a program that ends between the commits to both leaves
/// a difference.
void recordIdentityFingerprints(Study& study, const storage::SessionRow& session);

/// Deletes the names that were given in a session, because its participant declines, and notes in
/// the audit trail which rows of identity.db are gone.
void removeNames(Study& study, const storage::SessionRow& session);

/// The fingerprints of a participant's rows in identity.db, in the format of the event
/// NotedIdentities ("name=fingerprint …"); empty if there are no rows.
std::string fingerprintsOf(Study& study, const std::string& participant);

/// Notes in the audit trail the fingerprints of rows whose texts were sealed by a program that
/// ended before it noted them. A row counts as such only if the trail has the fingerprint that it
/// had before.
/// @throws StorageError  if names are locked.
void recordFingerprintsOfSealedRows(Study& study);

/// Compares identity.db with the audit trail, row by row.
storage::Findings checkIdentities(Study& study);

}  // namespace study
