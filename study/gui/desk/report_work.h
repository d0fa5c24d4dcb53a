#pragma once

#include <string>

#include "study/model/progress.h"
#include "study/model/run_mode.h"
#include "study/report/figures/figure_format.h"
#include "study/report/pdf_report.h"
#include "study/results/apa_text.h"

namespace study::gui {

/// A request for a report: its contents, and the file to write it to.
struct ReportRequest {
  std::string folder;  ///< the study's folder
  RunMode mode = RunMode::Live;
  std::string language = "en";
  Wording wording = Wording::Apa;
  report::Paper paper = report::Paper::A4;  ///< of a PDF
  bool hasQuotes = true;                    ///< shows what participants wrote
  std::string out;              ///< ends in .html or .pdf; an existing file is not overwritten
  std::string figures;          ///< folder for each figure as a file of its own; empty: none
  report::FigureFormat format;  ///< of these files
  std::string reason;           ///< why results of participants are unblinded, for the audit trail
};

/// Writes the report as `palpate report` does. Can be called from any thread.
/// @return  as study::noteCopy()
/// @throws storage::StorageError, UserError  with a message for the user.
bool write(const ReportRequest& request, const Progress& progress);

}  // namespace study::gui
