#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numerics/interval.h"
#include "questionnaires/scoring/scoring.h"
#include "study/results/protocol_versions.h"
#include "study/storage/records.h"

namespace study {

/// One score of an instrument in one cohort, about one condition (if the instrument is about
/// conditions).
struct ScoreSummary {
  std::string score;  ///< its id
  std::string cohort;
  std::string condition;       ///< empty if the instrument is not about a condition
  std::string occasion;        ///< "before", "after" or "change" if the change between two forms is
                               ///< scored; otherwise empty
  std::vector<double> values;  ///< for each participant, the mean over their forms
  std::size_t missing = 0;     ///< forms that answer items of the score, but not enough to compute
                               ///< it; for "change", participants without a change
  std::optional<double> mean;
  std::optional<double> standardDeviation;     ///< of a sample: divided by n − 1
  std::optional<analysis::Interval> interval;  ///< 95 % confidence interval of the mean
};

/// How many participants of one cohort answered an item acceptably about one condition. The last
/// answer of each participant counts.
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
  std::size_t forms = 0;          ///< number of answered forms
  std::size_t contradictory = 0;  ///< number of answered forms with contradictory answers
};

/// Scores every form by the rules of its instrument (questionnaires/scoring/scoring.h). A form is
/// the answers of one visit. Scores and contradictions are those of the form's own version, and
/// scores on another scale than that of the newest version are left out; acceptable is what the
/// newest version calls so.
/// @param sessions  the sessions that are evaluated
/// @param answers  all answers of these sessions
std::vector<InstrumentSummary> summariseInstruments(
    const ProtocolVersions& versions,
    const std::map<SessionId, storage::SessionRecord>& sessions,
    const std::vector<storage::AnswerRecord>& answers);

}  // namespace study
