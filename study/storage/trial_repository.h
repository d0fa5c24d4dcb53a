#pragma once

#include <optional>

#include "study/model/ids.h"
#include "study/model/trial_record.h"
#include "study/storage/database.h"

namespace study::storage {

/// The tables of trials and their cuts.
class TrialRepository {
 public:
  explicit TrialRepository(Database& database) : database_(database) {}

  /// Writes a trial inside the caller's transaction. What was measured is sealed if the database
  /// has the study's key, but for simulated sessions.
  void add(const VisitKey& visit, const TrialRecord& record);

 private:
  void addOpen(const VisitKey& visit, const TrialRecord& record);
  bool isSimulated(SessionId session) const;
  void addCut(const VisitKey& visit, std::int64_t number, const TrialRecord::Cut& cut);

  Database& database_;
};

}  // namespace study::storage
