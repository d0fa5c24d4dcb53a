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

/// One score of an instrument in one cohort, about one condition.
struct ScoreSummary {
  std::string score;  ///< its id
  std::string cohort;
  std::string condition;       ///< empty if the instrument is not about a condition
  std::string occasion;        ///< "before", "after", "change" if the change is scored; or empty
  std::vector<double> values;  ///< one for each participant, the mean of their forms
  std::size_t missing = 0;     ///< forms with answers to its items but without a score
  std::optional<double> mean;
  std::optional<double> standardDeviation;     ///< with n - 1
  std::optional<analysis::Interval> interval;  ///< of the mean, at 95 %
};

/// How many participants of one cohort answered acceptably about one condition, by the last answer
/// of each.
struct AcceptabilitySummary {
  std::string cohort;
  std::string condition;  ///< empty if the instrument is not about a condition
  questionnaires::Acceptability item;
  std::optional<analysis::Interval> interval;  ///< Wilson's, at 95 %
};

/// The summary of an instrument that has scores, thresholds or a consistency rule.
struct InstrumentSummary {
  std::string instrument;
  std::vector<ScoreSummary> scores;
  std::vector<AcceptabilitySummary> acceptable;
  std::size_t forms = 0;          ///< that were answered
  std::size_t contradictory = 0;  ///< of these, with contradictory answers
};

/// Scores every form by the rules of its instrument (questionnaires/scoring/scoring.h). A form is
/// the answers of one visit.
/// @param sessions  whose answers count
/// @param answers  of those sessions
std::vector<InstrumentSummary> summariseInstruments(
    const protocols::LoadedProtocol& loaded,
    const std::map<SessionId, storage::SessionRecord>& sessions,
    const std::vector<storage::AnswerRecord>& answers);

}  // namespace study
