#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/data/moments.h"
#include "study/results/apa_text.h"
#include "study/results/rendered_force_curves.h"
#include "study/results/results.h"
#include "study/session/analysis_plan_history.h"
#include "study/session/study.h"
#include "study/storage/evidence/signed_head.h"
#include "study/storage/records.h"
#include "study/words/words.h"

namespace study::report {

/// Figures as SVG elements; empty if they were not painted.
struct FamilyFigures {
  std::string answers;           ///< how often each point was chosen
  std::string participantMeans;  ///< the rating of every participant
  std::string effects;           ///< differences between methods
  std::string mainEffects;       ///< the figure of the main family beside the answer, without the
                                 ///< comparisons that its sentences leave out
  std::string sites;             ///< differences by site, pooled; empty if there are not several
};

/// The answers to one item, by alternative.
struct ItemFigure {
  std::string instrument;
  std::string item;
  std::string svg;
};

struct Figures {
  std::vector<FamilyFigures> families;
  std::vector<ItemFigure> items;
  std::string votes;
  std::vector<std::string> renderedForce;  ///< one for each device
};

/// The trials of a condition whose scene asked for more force than the device may give.
struct SaturatedTrials {
  std::string condition;
  int trials = 0;              ///< all of the condition
  std::vector<double> shares;  ///< shares of the contact time, 0 to 1, one for each such trial, in
                               ///< ascending order
};

/// The trials and cuts of a condition that count.
struct ConditionTrials {
  std::string condition;
  int trials = 0;
  std::int64_t cuts = 0;
};

/// Why trials did not pass.
struct TrialReasons {
  std::vector<base::Message> reasons;  ///< the reasons of the first of these trials
  int trials = 1;                      ///< number of trials with reasons of the same kinds
};

/// The trials of completed sessions that did not go as planned, without the optional ones before a
/// preference.
struct InterruptedTrials {
  std::map<TrialEnding, int> brokenOff;  ///< visits, by the reason
  int repeated = 0;                      ///< visits that were finished and then repeated
  std::map<std::string, int> skipped;    ///< trials that were never finished, by block
};

/// How well the trials of a study were rendered. Counts the trials of completed sessions that were
/// finished and not repeated, without the optional ones before a preference.
struct TrialQuality {
  int trials = 0;
  int optionalTrials = 0;  ///< accepted optional trials before a preference; not counted in trials
  int pass = 0;
  int warn = 0;
  int fail = 0;
  std::int64_t cuts = 0;
  double saturated = 0.0;  ///< time in which the scene asked for more than the limit [s]
  double contact = 0.0;    ///< time in contact with the tissue [s]
  std::optional<double>
      worstLateness;  ///< largest 99th percentile of a trial [µs]; std::nullopt in simulated time
  double rate = 0.0;  ///< nominal rate of the force loop [Hz]; 0 without trials
  std::vector<ConditionTrials> conditions;       ///< rendered ones, in the protocol's order
  std::vector<SaturatedTrials> saturatedTrials;  ///< by condition, in the protocol's order
  std::vector<TrialReasons> reasons;             ///< without the reason that the force was limited
  InterruptedTrials interrupted;
};

/// Travel and force at a landmark, over all cuts of a condition that count; each cut counts once.
struct LandmarkSummary {
  std::string condition;
  std::string_view landmark;  ///< in English
  analysis::Summary travel;   ///< [device's travel unit]; n = 0: it has no place
  analysis::Summary force;    ///< [N]
};

/// One study in a report: everything that is printed, computed once.
struct ReportSection {
  protocols::Protocol protocol;
  std::vector<questionnaires::Instrument> instruments;
  std::vector<protocols::SceneDataSource> sources;
  std::string protocolHash;
  AnalysisPlanHistory history;  ///< of the protocol's versions
  std::uint64_t seed = 0;
  std::string uuid;
  std::string firstDay = {};     ///< of the sessions that count [YYYY-MM-DD]; empty if none count
  std::string lastDay = {};      ///< of the sessions that count, by their beginning
  int sessionsWithForces = 0;    ///< sessions that count whose operator saw the forces
  storage::TrailEnd trail = {};  ///< end of the audit trail when it was read; empty in simulated
                                 ///< sessions
  /// The commitment to the secret that determines orders and codes (BlindingSecret::commitment());
  /// empty in simulated sessions, and in studies without a secret.
  std::string commitment = {};
  Results results;
  std::vector<RenderedForceCurve> curves = {};
  base::Message curvesReason = {};  ///< why there are no curves, if the traces could not be read
  TrialQuality quality = {};
  std::vector<LandmarkSummary> landmarks = {};    ///< condition by condition, of those with cuts
  std::vector<questionnaires::Problem> warnings;  ///< of the protocol's validation
  bool hasQuotes = true;                          ///< whether what participants wrote is shown
  Wording wording = Wording::Apa;                 ///< of the sentences
  Figures figures = {};
  words::Words words;  ///< in the language of the report

  /// nullptr if the study has no such questionnaire.
  const questionnaires::Instrument* instrument(std::string_view id) const;
  const std::string& conditionTitle(const std::string& condition) const;
  /// The index among the protocol's conditions, from 0; it selects the condition's colour in every
  /// figure.
  int conditionIndex(const std::string& condition) const;
  const std::string& cohortTitle(const std::string& cohort) const;
  /// "FEM (finite elements)": the title of a condition; behind an abbreviation the name of its
  /// force model, if it is known.
  std::string introducedTitle(const std::string& condition) const;
  /// "round 2 (also seen)": a block in words, by its number; what was seen where blocks differ in
  /// that.
  std::string blockTitle(const std::string& block) const;
  /// A message in the report's language, with titles in place of the ids of conditions, cohorts,
  /// blocks, instruments and items in its arguments.
  std::string inWords(const base::Message& message) const;
  /// The title of the condition, cohort, instrument, item or block with this id; the id itself if
  /// there is none.
  std::string titleOf(const std::string& id) const;
};

/// What kind of sessions the results are of; empty for live ones.
std::string originInWords(const ReportSection& section);

/// "Interpolation, FEM and KF".
std::string listed(const std::vector<std::string>& names, const words::Words& words);

/// The question; for an item with two opposite words both of them.
std::string questionOf(const questionnaires::Item& item, const std::string& language);

/// The words at the ends of an item's scale; empty where it has none, or where the laboratory has
/// still to fill them in.
std::pair<std::string, std::string> scaleEndWords(
    const questionnaires::Item& item, const std::string& language);

/// "scale from 1 (strongly disagree) to 5 (strongly agree)": the common scale of several items,
/// without words if they differ in them; empty if they have no common scale.
std::string scaleInWords(
    const std::vector<const questionnaires::Item*>& items, const words::Words& words);

/// The scale of what a family compares, in words.
std::string scaleInWords(const ReportSection& section, const protocols::Family& family);

/// The unit of what a family compares, in words: that of its items, or "points".
std::string unitInWords(const ReportSection& section, const protocols::Family& family);

/// A number with this unit: "0.41 points", "4.80 N".
std::string withUnit(
    const ReportSection& section, const protocols::Family& family, const std::string& number);

/// The figures that were painted: pairs of a file name ("realism-answers") and the SVG element.
std::vector<std::pair<std::string, std::string>> namedFigures(const ReportSection& section);

/// Reads a study and computes the results of its sessions of @p mode. Trials and their traces are
/// not read.
/// @throws storage::StorageError  if the study cannot be read.
ReportSection gatherResults(Study& study, RunMode mode, const words::Words& words = {});

/// Reads a study and computes what a report shows of its sessions of @p mode. Figures are not
/// painted.
/// @throws storage::StorageError  if the study cannot be read.
ReportSection gather(Study& study, RunMode mode, const words::Words& words = {});

}  // namespace study::report
