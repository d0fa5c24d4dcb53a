#include <cstdio>
#include <cstdlib>
#include <memory>

#include <QGuiApplication>
#include <QString>

#include "study/app/paint_figures.h"
#include "study/report/figures/chart_painter.h"
#include "study/report/figures/figure_files.h"
#include "study/report/figures/figures.h"
#include "study/report/marked_text.h"
#include "study/report/pdf_report.h"

namespace study::app {
namespace {

/// Prints Qt's messages, except the one that there is no desktop session, which Qt prints at every
/// start on a server.
void printQtMessage(
    QtMsgType /*type*/, const QMessageLogContext& /*context*/, const QString& words) {
  if (words.contains(QLatin1String("XDG_RUNTIME_DIR"))) return;
  std::fprintf(stderr, "%s\n", words.toUtf8().constData());
}

/// Qt needs an application object for fonts, but no display. nullptr if one exists already.
std::unique_ptr<QGuiApplication> applicationForFonts() {
  static int argc = 1;
  static char name[] = "palpate";
  static char* argv[] = {name, nullptr};
  if (QCoreApplication::instance() != nullptr) return nullptr;
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  qInstallMessageHandler(printQtMessage);
  return std::make_unique<QGuiApplication>(argc, argv);
}

}  // namespace

void paintFigures(std::vector<report::ReportSection>& sections) {
  const auto application = applicationForFonts();
  for (auto& section : sections) report::paintFigures(section);
}

void paintFigures(report::Document& document) {
  const auto application = applicationForFonts();
  for (auto& part : document.parts) {
    for (auto& figure : part.figures) figure.svg = report::chartAsSvg(figure.chart);
  }
}

std::string pdfOf(const std::string& html, const std::string& title, report::Paper paper) {
  const auto application = applicationForFonts();
  return report::asPdf(html, title, paper);
}

std::string htmlOf(const std::string& text) {
  const auto application = applicationForFonts();
  return report::asHtml(QString::fromStdString(text)).toStdString();
}

int writeFigures(
    report::ReportSection& section,
    const std::filesystem::path& folder,
    const report::FigureFormat& format) {
  const auto application = applicationForFonts();
  return report::writeFigures(section, folder, format);
}

}  // namespace study::app
