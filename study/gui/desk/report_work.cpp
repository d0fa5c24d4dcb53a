#include "study/gui/desk/report_work.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/report/figures/figure_files.h"
#include "study/report/figures/figures.h"
#include "study/report/html_report.h"
#include "study/report/pdf_report.h"
#include "study/session/unblinding.h"

namespace study::gui {
namespace {

/// Called before the computation. Throws if the report could not be written to @p out.
void requireWritable(const std::string& out) {
  const auto ending = std::filesystem::path(out).extension();
  if (ending != ".html" && ending != ".pdf") {
    throw UserError(
        "A report is a page (.html) or a PDF (.pdf), not '" + out + "'. Choose another name.");
  }
  requireNewFile(out);
}

}  // namespace

bool write(const ReportRequest& request, const Progress& progress) {
  constexpr double kStep = 0.25;  // one of four steps
  requireWritable(request.out);
  auto study = Study::open(request.folder, accessForUnblinding(request.reason));
  const auto sessions = study.sessions().all();
  const bool hasAny = std::any_of(sessions.begin(), sessions.end(), [&](const auto& session) {
    return session.runMode == request.mode;
  });
  if (!hasAny) {
    throw UserError(
        "No " + std::string(nameOf(request.mode)) +
        " participant has taken part yet. Choose other "
        "sessions.");
  }
  recordUnblinding(study, request.mode, EventKind::UnblindedReport, request.reason);
  const bool areFiguresNoted =
      request.figures.empty() || recordReportPath(study, request.mode, "figures", request.figures);
  announceProgress(progress, 0.0, "computing the tables, and what was felt");
  std::vector<report::ReportSection> sections;
  sections.push_back(report::gather(study, request.mode, words::wordsIn(request.language)));
  sections.back().wording = request.wording;
  sections.back().hasQuotes = request.hasQuotes;
  announceProgress(progress, kStep, "drawing the figures");
  report::paintFigures(sections.front());
  announceProgress(progress, 2 * kStep, "laying out the page");
  const auto html = report::asHtml(sections);
  const bool isPdf = std::filesystem::path(request.out).extension() == ".pdf";
  const auto page =
      isPdf ? report::asPdf(html, sections.front().protocol.study.title, request.paper) : html;
  announceProgress(progress, 3 * kStep, "writing it");
  const bool isNoted = recordReportPath(study, request.mode, "report", request.out, page);
  writeNewFile(request.out, page);
  if (!request.figures.empty()) {
    std::filesystem::create_directories(request.figures);
    report::writeFigures(sections.front(), request.figures, request.format);
  }
  return areFiguresNoted && isNoted;
}

}  // namespace study::gui
