#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/data_table.h"
#include "study/run_mode.h"
#include "study/study.h"

namespace study {

enum class ExportFormat { Csv, Json };

struct ExportOptions {
  ExportFormat format = ExportFormat::Csv;
  std::optional<RunMode> runMode;  ///< nothing: all, each row says which
  bool isBlinded = true;           ///< condition codes instead of conditions
};

/// Everything an analyst needs, as tables: sessions, responses, trials, cuts, events. Blinded,
/// nothing in them says which rendering an alternative was: a condition bears a code that is drawn
/// from the study's seed and means the same in every row.
std::vector<DataTable> exportTables(Study& study, const ExportOptions& options);

/// Writes the tables, a codebook and a README into a folder that does not exist yet, all or
/// nothing: the folder appears when it is complete. Without blinding, @p reason is written into the
/// audit trail, and there must be one.
/// @throws storage::StorageError  if the folder is there already or cannot be written.
void exportStudy(
    Study& study,
    const std::string& folder,
    const ExportOptions& options,
    const std::string& reason = {});

/// The codes under which conditions go in exports: "C2". Conditions that a later version of the
/// protocol adds get new ones; no code ever changes.
std::map<std::string, std::string> conditionCodes(Study& study);

}  // namespace study
