#pragma once

#include <string>

#include "study/model/progress.h"
#include "study/model/run_mode.h"

namespace study::gui {

/// Which report, of what.
struct ReportOrder {
  std::string folder;  ///< of the study
  RunMode mode = RunMode::Live;
  std::string language = "en";
  std::string out;     ///< .html or .pdf; nothing is overwritten
  std::string reason;  ///< why conditions are named beside live sessions' results
};

/// Writes it, as `palpate report` does. May run in any thread.
/// @throws storage::StorageError, UserError  in words.
void write(const ReportOrder& order, const Progress& progress);

}  // namespace study::gui
