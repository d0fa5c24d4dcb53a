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

bool write(const ReportRequest& order, const Progress& progress) {
  constexpr double kStep = 0.25;  // one of four steps
  requireWritable(order.out);
  auto study = Study::open(order.folder, accessForUnblinding(order.reason));
  const auto sessions = study.sessions().all();
  const bool hasAny = std::any_of(sessions.begin(), sessions.end(), [&](const auto& session) {
    return session.runMode == order.mode;
  });
  if (!hasAny) {
    throw UserError(
        "No " + std::string(nameOf(order.mode)) +
        " participant has taken part yet. Choose other "
        "sessions.");
  }
  recordUnblinding(study, order.mode, EventKind::UnblindedReport, order.reason);
  const bool areFiguresNoted =
      order.figures.empty() || recordReportPath(study, order.mode, "figures", order.figures);
  tell(progress, 0.0, "computing the tables, and what was felt");
  std::vector<report::ReportSection> sections;
  sections.push_back(report::gather(study, order.mode, words::wordsIn(order.language)));
  sections.back().wording = order.wording;
  sections.back().hasQuotes = order.hasQuotes;
  tell(progress, kStep, "drawing the figures");
  report::paintFigures(sections.front());
  tell(progress, 2 * kStep, "laying out the page");
  const auto html = report::asHtml(sections);
  const bool isPdf = std::filesystem::path(order.out).extension() == ".pdf";
  const auto page =
      isPdf ? report::asPdf(html, sections.front().protocol.study.title, order.paper) : html;
  tell(progress, 3 * kStep, "writing it");
  const bool isNoted = recordReportPath(study, order.mode, "report", order.out, page);
  writeNewFile(order.out, page);
  if (!order.figures.empty()) {
    std::filesystem::create_directories(order.figures);
    report::writeFigures(sections.front(), order.figures, order.format);
  }
  return areFiguresNoted && isNoted;
}

}  // namespace study::gui
