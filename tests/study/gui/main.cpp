#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QString>
#include <QTemporaryDir>

#include "study/gui/widgets/theme.h"
#include "tests/support/standstill.h"

namespace {

/// Drops a message that the offscreen platform prints for each window, and prints all others.
void say(QtMsgType /*type*/, const QMessageLogContext& /*context*/, const QString& words) {
  const bool isOfThePlatform = words.contains(QLatin1String("propagateSizeHints")) ||
                               words.contains(QLatin1String("does not support raise"));
  if (!isOfThePlatform) {
    std::fprintf(stderr, "%s\n", words.toUtf8().constData());
  }
}

}  // namespace

int main(int argc, char** argv) {
  // Windows are tested without a display, also when the tests are listed at build time.
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  qInstallMessageHandler(say);
  QApplication application(argc, argv);
  const QTemporaryDir settings;  // tests must not depend on the user's settings
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  setenv("PALPATE_STATION", settings.filePath("station").toUtf8().constData(), 0);
  study::gui::applyTheme(application);
  testing::InitGoogleTest(&argc, argv);
  return tests::runAllTests();
}
