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

/// The offscreen platform says this of every window; the rest is worth reading.
void say(QtMsgType /*type*/, const QMessageLogContext& /*context*/, const QString& words) {
  const bool isOfThePlatform = words.contains(QLatin1String("propagateSizeHints")) ||
                               words.contains(QLatin1String("does not support raise"));
  if (!isOfThePlatform) {
    std::fprintf(stderr, "%s\n", words.toUtf8().constData());
  }
}

}  // namespace

int main(int argc, char** argv) {
  // Windows are tested without a display; tests are also listed at build time.
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  qInstallMessageHandler(say);
  QApplication application(argc, argv);
  const QTemporaryDir settings;  // what somebody has chosen on this computer is nobody's test
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  study::gui::applyTheme(application);
  testing::InitGoogleTest(&argc, argv);
  return tests::runAllTests();
}
