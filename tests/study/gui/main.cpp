#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include <QApplication>
#include <QString>

#include "study/gui/theme.h"

namespace {

/// The offscreen platform says this at every window; the rest is worth reading.
void say(QtMsgType /*type*/, const QMessageLogContext& /*context*/, const QString& words) {
  if (!words.contains(QLatin1String("propagateSizeHints"))) {
    std::fprintf(stderr, "%s\n", words.toUtf8().constData());
  }
}

}  // namespace

int main(int argc, char** argv) {
  // Windows are tested without a display; tests are also listed at build time.
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  qInstallMessageHandler(say);
  QApplication application(argc, argv);
  study::gui::applyTheme(application);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
