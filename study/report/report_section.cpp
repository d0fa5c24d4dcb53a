#include "study/report/report_section.h"

#include <algorithm>

namespace study::report {
namespace {

TrialQuality qualityOf(Study& study, RunMode mode) {
  const storage::Records records(study.database());
  std::vector<SessionId> wanted;
  for (const auto& session : records.sessions()) {
    if (session.runMode == nameOf(mode)) wanted.push_back(session.id);
  }
  TrialQuality quality;
  for (const auto& trial : records.trials()) {
    if (std::find(wanted.begin(), wanted.end(), trial.step.visit.session) == wanted.end()) continue;
    ++quality.trials;
    quality.pass += trial.verdict == "PASS" ? 1 : 0;
    quality.warn += trial.verdict == "WARN" ? 1 : 0;
    quality.fail += trial.verdict == "FAIL" ? 1 : 0;
    quality.cuts += trial.cuts;
    quality.saturated += trial.saturated;
    quality.contact += trial.contact;
    if (trial.latenessP99) {
      quality.worstLateness = std::max(quality.worstLateness.value_or(0.0), *trial.latenessP99);
    }
    const bool isNew =
        !trial.verdictReason.empty() &&
        std::find(quality.reasons.begin(), quality.reasons.end(), trial.verdictReason) ==
            quality.reasons.end();
    if (isNew) quality.reasons.push_back(trial.verdictReason);
  }
  return quality;
}

/// What `palpate protocol check` says about the protocol that the study keeps.
std::vector<questionnaires::Problem> warningsOf(Study& study) {
  const auto stored = study.protocols().current();
  const auto find = [&](const std::string& name) -> std::optional<std::string> {
    for (const auto& file : stored.files) {
      if (file.name == name) return file.text;
    }
    return std::nullopt;
  };
  questionnaires::Problems problems;
  protocols::loadProtocol(stored.text, find, problems);
  return problems.all();
}

}  // namespace

const std::string& ReportSection::conditionTitle(const std::string& condition) const {
  return protocol.condition(condition)->title;
}

const std::string& ReportSection::cohortTitle(const std::string& cohort) const {
  return protocol.cohort(cohort)->title.in("en");
}

ReportSection gather(Study& study, RunMode mode) {
  return {
      .protocol = study.protocol().protocol,
      .instruments = study.protocol().instruments,
      .protocolHash = study.protocols().current().sha256,
      .seed = study.seed(),
      .uuid = study.uuid(),
      .results = computeResults(study, mode),
      .curves = feltCurves(study, mode),
      .quality = qualityOf(study, mode),
      .warnings = warningsOf(study),
      .figures = {}};
}

}  // namespace study::report
