#include <cstdlib>
#include <memory>

#include <QGuiApplication>

#include "study/app/paint_figures.h"
#include "study/report/figures.h"

namespace study::app {

void paintFigures(std::vector<report::ReportSection>& sections) {
  // Fonts need an application; a display they do not need.
  static int argc = 1;
  static char name[] = "palpate";
  static char* argv[] = {name, nullptr};
  std::unique_ptr<QGuiApplication> application;
  if (QCoreApplication::instance() == nullptr) {
    setenv("QT_QPA_PLATFORM", "offscreen", 0);
    application = std::make_unique<QGuiApplication>(argc, argv);
  }
  for (auto& section : sections) report::paintFigures(section);
}

}  // namespace study::app
