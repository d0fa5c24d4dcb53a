#pragma once

#include <string>
#include <utility>
#include <vector>

#include "study/results/felt_curves.h"
#include "study/results/results.h"
#include "study/session/plan_history.h"
#include "study/session/study.h"
#include "study/storage/records.h"
#include "study/words/words.h"

namespace study::report {

/// Figures as SVG, ready to stand in a page; empty where nobody painted them.
struct FamilyFigures {
  std::string answers;    ///< how often each point was chosen
  std::string people;     ///< what every participant thought
  std::string effects;    ///< how far methods lie apart
  std::string positions;  ///< what the order did
};

struct Figures {
  std::vector<FamilyFigures> families;
  std::string votes;
  std::vector<std::string> felt;  ///< one for each device
  std::string timing;
};

/// How late the ticks of a trial were.
struct TrialTiming {
  std::string device;
  double p99 = 0.0;      ///< [µs]
  double largest = 0.0;  ///< [µs]
};

/// How the trials of a study were rendered, counted: those of completed sessions that were finished
/// and not repeated, without what was felt once more before a choice.
struct TrialQuality {
  int trials = 0;
  int feltAgain = 0;  ///< besides: offered before a choice, and felt
  int pass = 0;
  int warn = 0;
  int fail = 0;
  std::int64_t cuts = 0;
  double saturated = 0.0;  ///< [s]
  double contact = 0.0;    ///< [s]
  std::optional<double>
      worstLateness;  ///< the largest p99 of a trial [µs]; nothing in virtual time
  std::vector<std::vector<base::Message>> reasons;  ///< of all that did not pass
  std::vector<TrialTiming> timings;  ///< in the order of the trials; none in virtual time
};

/// One study in a report: everything that is printed, computed once.
struct ReportSection {
  protocols::Protocol protocol;
  std::vector<questionnaires::Instrument> instruments;
  std::vector<protocols::FeltSource> sources;
  std::string protocolHash;
  PlanHistory history;  ///< of the protocol's versions
  std::uint64_t seed = 0;
  std::string uuid;
  Results results;
  std::vector<FeltCurve> curves;
  base::Message curvesReason;  ///< why there are none, where the traces do not tell
  TrialQuality quality;
  std::vector<questionnaires::Problem> warnings;  ///< that the protocol's check gives
  Figures figures;
  words::Words words;  ///< in whose language all is written

  const std::string& conditionTitle(const std::string& condition) const;
  /// Among the protocol's conditions, from 0: what its colour is chosen by in every figure.
  int conditionPlace(const std::string& condition) const;
  const std::string& cohortTitle(const std::string& cohort) const;
};

/// The figures that were painted, each with a name for its file: "realism-answers".
std::vector<std::pair<std::string, std::string>> namedFigures(const ReportSection& section);

/// @throws storage::StorageError
ReportSection gather(Study& study, RunMode mode, const words::Words& words = {});

}  // namespace study::report
