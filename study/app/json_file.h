#pragma once

#include <string>
#include <vector>

#include "analysis/registry/registry.h"
#include "haptics/devices/device.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/rendered_slope.h"
#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/trace.h"
#include "protocols/model/loaded_protocol.h"
#include "protocols/model/protocol.h"
#include "questionnaires/json/problem.h"
#include "study/app/scene_cost.h"
#include "study/results/results.h"
#include "study/session/verification.h"

// The JSON documents that --json prints. Numbers can be read back exactly. An undefined value is
// null, with a reason.
namespace study::app {

/// The result of checking a file: its problems, and whether it is valid (@p isSound).
std::string problemsAsJson(
    const std::string& file, bool isSound, const std::vector<questionnaires::Problem>& problems);

/// The result of a test as one object; for a test with a row for each pair of groups, an object
/// with `comparisons`.
std::string testAsJson(
    const analysis::StatisticalTest& test,
    const analysis::TestData& data,
    const std::vector<analysis::TestRow>& rows,
    double level);

/// The results of a study, as `palpate stats run` computes them.
std::string resultsAsJson(Study& study, const Results& results);

/// The state of a study, as `palpate study status` shows it.
std::string statusAsJson(Study& study);

/// Blanks in texts as a list of `key`, `title`, and `text` by language; `text` is null if the blank
/// is not filled in.
std::string blanksAsJson(const std::vector<protocols::Blank>& blanks);

std::string verificationAsJson(const Verification& verification);

/// The result of an import: `rows`, `sample_rate_hz`, `saturated_rows`, `max_force_n`, `cuts` …;
/// rows are numbered from 1. `chosen` is the imported cut, with its recorded samples and the curve
/// that would be rendered; null with a `reason` if no cut was imported.
std::string importAsJson(
    const haptics::recordings::Recording& recording,
    const haptics::recordings::RecordingSurvey& survey,
    const haptics::recordings::Trace& trace,
    const std::optional<haptics::recordings::ImportedCut>& imported,
    const std::string& whyNot);

/// The values of `noise` in a protocol.
std::string processNoiseAsJson(const haptics::recordings::ProcessNoise& noise);

/// The passes of a scene. `torque` is present if the scene has one, and says whether @p device
/// renders it. Costs are left out if @p costs is empty.
std::string passesAsJson(
    const protocols::Condition& condition,
    const haptics::engine::CompiledScene& scene,
    const haptics::engine::RenderedSlope& slope,
    const haptics::devices::Capabilities& device,
    const std::vector<SceneCost>& costs);

}  // namespace study::app
