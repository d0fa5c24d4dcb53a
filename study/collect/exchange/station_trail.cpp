#include "study/collect/exchange/station_trail.h"

#include "study/storage/evidence/trail_heads.h"
#include "study/storage/statement.h"
#include "study/storage/study_schema.h"

namespace study::collect {

std::vector<std::string> problemsIn(
    const std::vector<storage::StoredEvent>& trail,
    const std::string& study,
    const std::string& key) {
  // In a study without sessions, by the same code that verifies one.
  auto database = storage::Database::inMemory(storage::studySchema());
  database.execute("PRAGMA foreign_keys = OFF; BEGIN");
  storage::Statement row(
      database,
      "INSERT INTO study (id, uuid, seed, random_version, app_version, created_utc) "
      "VALUES (1, ?, '', 0, '', '')");
  row.bind(1, study);
  row.run();
  storage::EventLog log(database);
  for (const auto& event : trail) log.putStored(event);
  database.execute("COMMIT");
  std::vector<std::string> problems;
  if (const auto broken = log.firstBreak()) problems.push_back(*broken);
  const storage::TrailHeads heads(database);
  for (const auto& problem : heads.checkSignatures(key).problems) problems.push_back(problem);
  for (const auto& each : heads.all()) {
    if (each.head.key == key) continue;
    problems.push_back(
        "event " + std::to_string(each.seq) +
        " is signed by another station than the one that "
        "was enrolled");
  }
  return problems;
}

}  // namespace study::collect
