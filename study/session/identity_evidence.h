#pragma once

#include <string>

#include "study/session/study.h"
#include "study/storage/evidence/findings.h"

namespace study {

/// A keyed hash of a row of identity.db as it is stored, for the audit trail: it changes with the
/// row, and says nothing of it to anyone without the study's secret. Empty if there is no such row,
/// and in studies that have no secret.
std::string fingerprintOf(
    Study& study, const storage::IdentityStore::Place& place, const std::string& item);

/// Notes in the audit trail what identity.db has and the trail does not know, of the step that a
/// session stands at. The two are different files: a program that ended between their commits
/// leaves them different.
void noteIdentities(Study& study, const storage::SessionRow& session);

/// The fingerprints of what identity.db has of a participant, as the event NotedIdentities has
/// them; empty if there is nothing.
std::string fingerprintsOf(Study& study, const std::string& participant);

/// Compares identity.db with the audit trail, row by row.
storage::Findings checkIdentities(Study& study);

}  // namespace study
