#include "study/gui/desk/measurement_work.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "haptics/reaming/material/material_fit.h"
#include "haptics/reaming/material/series.h"
#include "haptics/reaming/packing/packed_bone.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"
#include "haptics/recordings/recording.h"
#include "protocols/reading/material_file.h"
#include "protocols/reading/packing_file.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/session/import_recording.h"
#include "study/storage/protocol_repository.h"

namespace study::gui {
namespace {

namespace fs = std::filesystem;
namespace reaming = haptics::reaming;

/// Called before the computation. Throws if the result could not be written to @p out.
void requireNewFileEndingIn(const std::string& out, std::string_view ending) {
  if (!out.ends_with(ending)) {
    throw UserError(
        "'" + out + "' does not end in " + std::string(ending) + ". Choose another name.");
  }
  requireNewFile(out);
}

/// The test named in a file name; std::nullopt if the name has no test.
std::optional<reaming::TestSet> testOf(const std::string& name) {
  for (std::size_t i = 0; i < reaming::kTestSets.size(); ++i) {
    if (name.find(reaming::kTestSets[i]) != std::string::npos) {
      return static_cast<reaming::TestSet>(i);
    }
  }
  return std::nullopt;
}

std::vector<fs::path> seriesIn(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const auto ending = entry.path().extension();
    if (ending == ".csv" || ending == ".tsv" || ending == ".txt") files.push_back(entry.path());
  }
  if (error) throw UserError(folder + " cannot be read (" + error.message() + ").");
  if (files.empty()) {
    throw UserError(folder + " holds no series. Choose a folder with tables (.csv, .tsv, .txt).");
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Reports progress. Returns false if the user has cancelled, because the algorithm that calls it
/// does not allow exceptions.
bool onProgress(const Progress& progress, const reaming::PackingProgress& now, std::size_t wanted) {
  try {
    announceProgress(
        progress,
        static_cast<double>(now.spheres) / static_cast<double>(wanted),
        fmt::format(
            "{} of {} spheres, {:.1f} % covered", now.spheres, wanted, 100.0 * now.coverage));
    return true;
  } catch (const Cancelled&) {
    return false;
  }
}

}  // namespace

haptics::recordings::ImportReport importCutTo(
    const std::string& recording,
    const std::optional<haptics::recordings::RecordingColumns>& columns,
    const haptics::recordings::ImportOptions& options,
    const std::string& out,
    const Progress& progress) {
  requireNewFileEndingIn(out, ".json");
  announceProgress(progress, 0.0, "reading the recording");
  const auto read = readRecordingWithColumns(recording, columns);
  announceProgress(progress, 0.5, "taking the cut");
  auto imported = importRecording(read, options);
  announceProgress(progress, 0.9, "writing it");
  writeNewFile(out, cutAsJsonWithSource(recording, imported.cut));
  return std::move(imported.report);
}

FittedMaterial fitMaterialTo(
    const std::string& folder,
    const std::string& title,
    const std::string& out,
    const Progress& progress) {
  requireNewFileEndingIn(out, ".json");
  constexpr double kShareOfReading = 0.5;
  const auto files = seriesIn(folder);
  std::vector<reaming::Series> all;
  std::vector<protocols::MaterialSource> sources;
  for (const auto& file : files) {
    const auto name = file.filename().string();
    const double share = static_cast<double>(all.size()) / static_cast<double>(files.size());
    announceProgress(progress, kShareOfReading * share, "reading " + name);
    const auto test = testOf(name);
    if (!test) {
      throw UserError(
          "It is not clear which test " + name +
          " is of: its name has to contain static, dynamic-1 or dynamic-2.");
    }
    all.push_back(reaming::readSeriesFile(file.string(), *test, {}));
    sources.push_back({name, storage::sha256(reaming::contentOfSeriesFile(file.string()))});
  }
  const bool isSynthetic =
      std::any_of(all.begin(), all.end(), [](const auto& series) { return series.isSynthetic; });
  announceProgress(progress, kUnknownShare, "filtering, and fitting the curves");
  const reaming::FitOptions options;
  auto fit = reaming::fitMaterial(all, options);
  if (fit.sets.empty()) throw UserError("Every series was left out; there is nothing to fit.");
  announceProgress(progress, 1.0, "writing it");
  const auto name = fs::path(out).stem().string();
  writeNewFile(out, protocols::materialAsJson(name, title, isSynthetic, fit, options, sources));
  return {std::move(fit), isSynthetic};
}

reaming::PackedBone buildBoneTo(
    std::size_t spheres, std::uint64_t seed, const std::string& out, const Progress& progress) {
  requireNewFileEndingIn(out, protocols::kPackingExtension);
  const reaming::Acetabulum body;
  reaming::PackedBone bone{
      .name = fs::path(out).stem().string(), .title = "A cup of spheres", .isSynthetic = true};
  try {
    const auto packing = reaming::pack(
        body, {.count = spheres, .seed = seed}, [&](const reaming::PackingProgress& now) {
          return onProgress(progress, now, spheres);
        });
    if (!packing) throw Cancelled();
    bone.packing = *packing;
  } catch (const std::invalid_argument& wrong) {
    throw UserError(std::string("The spheres cannot be placed: ") + wrong.what() + ".");
  }
  announceProgress(progress, 1.0, "writing it");
  writeNewFile(
      out, protocols::packingAsText(bone, {.mesh = "parametric acetabulum", .seed = seed}));
  return bone;
}

}  // namespace study::gui
