#pragma once

#include <string>
#include <vector>

#include "study/felt_curves.h"
#include "study/results.h"
#include "study/storage/records.h"
#include "study/study.h"

namespace study::report {

/// Figures as SVG, ready to stand in a page; empty where nobody painted them.
struct Figures {
  std::vector<std::string> likert;  ///< one for each family
  std::string votes;
  std::vector<std::string> felt;  ///< one for each device
};

/// How the trials of a study were rendered, counted.
struct TrialQuality {
  int trials = 0;
  int pass = 0;
  int warn = 0;
  int fail = 0;
  std::int64_t cuts = 0;
  double saturated = 0.0;  ///< [s]
  double contact = 0.0;    ///< [s]
  std::optional<double>
      worstLateness;                 ///< the largest p99 of a trial [µs]; nothing in virtual time
  std::vector<std::string> reasons;  ///< of all that did not pass
};

/// One study in a report: everything that is printed, computed once.
struct ReportSection {
  protocols::Protocol protocol;
  std::vector<questionnaires::Instrument> instruments;
  std::string protocolHash;
  std::uint64_t seed = 0;
  std::string uuid;
  Results results;
  std::vector<FeltCurve> curves;
  TrialQuality quality;
  std::vector<questionnaires::Problem> warnings;  ///< that the protocol's check gives
  Figures figures;

  const std::string& conditionTitle(const std::string& condition) const;
  const std::string& cohortTitle(const std::string& cohort) const;
};

/// @throws storage::StorageError
ReportSection gather(Study& study, RunMode mode);

}  // namespace study::report
