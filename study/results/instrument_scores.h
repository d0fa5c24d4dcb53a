#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numerics/interval.h"
#include "protocols/model/loaded_protocol.h"
#include "questionnaires/scoring/scoring.h"
#include "study/storage/records.h"

namespace study {

/// A score of an instrument in one cohort, about one condition.
struct ScoreSummary {
  std::string score;  ///< its id
  std::string cohort;
  std::string condition;       ///< empty where the instrument asks about no condition
  std::string occasion;        ///< "before", "after", "change" where the change counts; else empty
  std::vector<double> values;  ///< one per participant, the mean of what they gave
  std::size_t missing = 0;     ///< forms that answered some of its items and gave no score
  std::optional<double> mean;
  std::optional<double> standardDeviation;     ///< with n - 1
  std::optional<analysis::Interval> interval;  ///< of the mean, at 95 %
};

/// Who found what an item asks about acceptable, in one cohort, about one condition: by what each
/// participant said last.
struct AcceptabilitySummary {
  std::string cohort;
  std::string condition;  ///< empty where the instrument asks about no condition
  questionnaires::Acceptability item;
  std::optional<analysis::Interval> interval;  ///< Wilson's, at 95 %
};

/// What an instrument with scores, thresholds or a rule of consistency came to.
struct InstrumentSummary {
  std::string instrument;
  std::vector<ScoreSummary> scores;
  std::vector<AcceptabilitySummary> acceptable;
  std::size_t forms = 0;          ///< that were answered
  std::size_t contradictory = 0;  ///< of these, whose answers contradict each other
};

/// Scores every form as its instrument says (questionnaires/scoring/scoring.h). A form is what one
/// visit answered.
/// @param sessions  whose answers count
/// @param answers  of those sessions
std::vector<InstrumentSummary> summariseInstruments(
    const protocols::LoadedProtocol& loaded,
    const std::map<SessionId, storage::SessionRecord>& sessions,
    const std::vector<storage::AnswerRecord>& answers);

}  // namespace study
