#include <cstdio>
#include <cstdlib>
#include <memory>

#include <QGuiApplication>
#include <QString>

#include "study/app/paint_figures.h"
#include "study/report/figures.h"

namespace study::app {
namespace {

/// A server has no desktop session, and Qt says so at every start; the rest is worth reading.
void say(QtMsgType /*type*/, const QMessageLogContext& /*context*/, const QString& words) {
  if (words.contains(QLatin1String("XDG_RUNTIME_DIR"))) return;
  std::fprintf(stderr, "%s\n", words.toUtf8().constData());
}

}  // namespace

void paintFigures(std::vector<report::ReportSection>& sections) {
  // Fonts need an application; a display they do not need.
  static int argc = 1;
  static char name[] = "palpate";
  static char* argv[] = {name, nullptr};
  std::unique_ptr<QGuiApplication> application;
  if (QCoreApplication::instance() == nullptr) {
    setenv("QT_QPA_PLATFORM", "offscreen", 0);
    qInstallMessageHandler(say);
    application = std::make_unique<QGuiApplication>(argc, argv);
  }
  for (auto& section : sections) report::paintFigures(section);
}

}  // namespace study::app
