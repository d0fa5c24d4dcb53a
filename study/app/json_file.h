#pragma once

#include <string>
#include <vector>

#include "analysis/registry/registry.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/rendered_slope.h"
#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/trace.h"
#include "questionnaires/json/problem.h"
#include "study/app/scene_cost.h"
#include "study/results/results.h"
#include "study/session/verification.h"

// What --json prints: one JSON document, numbers so that they read back exactly, null with a reason
// where something is undefined.
namespace study::app {

std::string problemsAsJson(
    const std::string& file, bool isSound, const std::vector<questionnaires::Problem>& problems);

/// One object; of a test with a row for each pair of groups an object with `comparisons`.
std::string testAsJson(
    const analysis::StatisticalTest& test,
    const analysis::TestData& data,
    const std::vector<analysis::TestRow>& rows,
    double level);

std::string resultsAsJson(Study& study, const Results& results);

std::string statusAsJson(Study& study);

std::string verificationAsJson(const Verification& verification);

/// `rows`, `sample_rate_hz`, `saturated_rows`, `max_force_n`, `cuts` …; rows are numbered from 1.
/// `chosen` is the cut that was taken, with its samples as recorded and its curve as it would be
/// felt; null, and `reason` says why, where none was.
std::string importAsJson(
    const haptics::recordings::Recording& recording,
    const haptics::recordings::RecordingSurvey& survey,
    const haptics::recordings::Trace& trace,
    const std::optional<haptics::recordings::ImportedCut>& imported,
    const std::string& whyNot);

/// The keys that a protocol's `noise` has.
std::string processNoiseAsJson(const haptics::recordings::ProcessNoise& noise);

/// The costs are left out where nobody measured them.
std::string passesAsJson(
    const std::string& condition,
    const haptics::engine::CompiledScene& scene,
    const haptics::engine::RenderedSlope& slope,
    const std::vector<SceneCost>& costs);

}  // namespace study::app
