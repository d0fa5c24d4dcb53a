#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/export/column.h"
#include "study/model/progress.h"
#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace study {

enum class ExportFormat {
  Csv,      ///< a table a file
  Json,     ///< one document
  PsychDs,  ///< tables with data dictionaries, as psych-ds.github.io lays them out
  Bids,     ///< a folder a person, as bids-specification.readthedocs.io lays them out
  R,        ///< a table a file, and a script in R that reads them with their types
  Python,   ///< … in Python
};

struct ExportOptions {
  ExportFormat format = ExportFormat::Csv;
  std::optional<RunMode> runMode;  ///< nothing: all, each row says which
  bool isBlinded = true;           ///< condition codes instead of conditions
  bool hasTraces = false;          ///< what was felt, tick by tick, besides
  /// For the public: of each person so many people the same is told (study/export/public_tables.h),
  /// and what else would give somebody away stays at home. Nothing: for those who may know.
  std::optional<std::size_t> publicClass = std::nullopt;
  /// Told how far the writing is; whatever it throws ends it, and there is no folder.
  Progress progress = {};
};

/// The fewest people that a class of a public export may have, where nobody asks for more.
inline constexpr std::size_t kSmallestPublicClass = 5;

/// Everything an analyst needs, as tables: sessions, responses, trials, cuts, events. Blinded,
/// nothing in them says which rendering an alternative was: a condition bears a code that is drawn
/// from the study's seed and means the same in every row.
std::vector<ExportedTable> exportTables(Study& study, const ExportOptions& options);

/// Writes the tables, a codebook and a README into a folder that does not exist yet, all or
/// nothing: the folder appears when it is complete. Without blinding, @p reason is written into the
/// audit trail, and there must be one; so is that a folder was made for the public.
/// @return  how many sessions are in it.
/// @throws storage::StorageError  if the folder is there already or cannot be written, or too few
/// people took part for a public one.
std::size_t exportStudy(
    Study& study,
    const std::string& folder,
    const ExportOptions& options,
    const std::string& reason = {});

/// The codes under which conditions go in exports: "C2". Conditions that a later version of the
/// protocol adds get new ones; no code ever changes.
std::map<std::string, std::string> conditionCodes(Study& study);

}  // namespace study
