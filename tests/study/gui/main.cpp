#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QMainWindow>
#include <QSettings>
#include <QString>
#include <QTemporaryDir>

#include "study/gui/desk/help_window.h"
#include "study/gui/widgets/theme.h"
#include "tests/support/standstill.h"

/// Fontconfig drops patterns that it has not freed; the leak sanitizer asks this function what to
/// suppress.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libfontconfig.so\n";
}

/// The address sanitizer asks this function for its settings. Qt is compiled without frame
/// pointers, so beyond the caller a stack of an allocation in it is no stack, and a new one each
/// time: to keep them all took a fourth of the time. A report that needs more frames:
/// ASAN_OPTIONS=malloc_context_size=30.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "malloc_context_size=2";
}

namespace {

/// Drops a message that the offscreen platform prints for each window, and prints all others.
void say(QtMsgType /*type*/, const QMessageLogContext& /*context*/, const QString& words) {
  const bool isOfThePlatform = words.contains(QLatin1String("propagateSizeHints")) ||
                               words.contains(QLatin1String("does not support raise"));
  if (!isOfThePlatform) {
    std::fprintf(stderr, "%s\n", words.toUtf8().constData());
  }
}

/// Fails a test in which a window is shown that the program's list of windows does not have, so
/// that none is left out by the tests that walk through the list. A widget that a test shows by
/// itself is no window of the program.
class EveryWindowIsListed final : public QObject {
 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* window = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::Show || window == nullptr || !window->isWindow()) return false;
    const auto kind = window->windowType();
    const bool isKind = kind == Qt::Window || kind == Qt::Dialog || kind == Qt::Tool;
    const bool isOpened = window->parentWidget() != nullptr ||
                          qobject_cast<const QDialog*>(window) != nullptr ||
                          qobject_cast<const QMainWindow*>(window) != nullptr;
    if (!isKind || !isOpened) return false;
    const std::string name = window->metaObject()->className();
    const bool isQtsOwn = name.starts_with('Q');
    const auto last = name.substr(name.rfind(':') + 1);
    const auto windows = study::gui::programWindows();
    const bool isListed = std::ranges::any_of(
        windows, [&](const study::gui::ProgramWindow& each) { return each.name == last; });
    if (!isListed && !isQtsOwn) ADD_FAILURE() << name << " is not in programWindows()";
    return false;
  }
};

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
  EveryWindowIsListed everyWindowIsListed;
  application.installEventFilter(&everyWindowIsListed);
  testing::InitGoogleTest(&argc, argv);
  return tests::runAllTests();
}
