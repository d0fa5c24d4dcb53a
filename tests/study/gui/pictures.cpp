#include "tests/study/gui/pictures.h"

#include <cstdlib>

#include <QApplication>
#include <QTest>

#include "study/gui/widgets/theme.h"

namespace tests {
namespace {

void save(QWidget& window, const QString& name) {
  QTest::qWait(60);
  const auto folder = QString::fromUtf8(std::getenv("PALPATE_PICTURES"));
  window.grab().save(QStringLiteral("%1/%2.png").arg(folder, name));
}

}  // namespace

void photographInAllThemes(QWidget& window, const QString& name) {
  using study::gui::ThemeName;
  if (std::getenv("PALPATE_PICTURES") == nullptr) return;
  const auto wear = [](ThemeName theme) {
    study::gui::applyTheme(*qobject_cast<QApplication*>(QApplication::instance()), theme);
  };
  for (const auto theme : {ThemeName::Dark, ThemeName::HighContrast, ThemeName::Light}) {
    wear(theme);
    save(window, name + QLatin1Char('-') + study::gui::nameOf(theme));
  }
  if (!window.isWindow() || window.isModal()) return;
  const QSize size = window.size();
  window.resize(1920, 1080);
  save(window, name + QStringLiteral("-large"));
  window.resize(size);
}

void keepPicture(const QImage& picture, const QString& name) {
  if (std::getenv("PALPATE_PICTURES") == nullptr) return;
  const auto folder = QString::fromUtf8(std::getenv("PALPATE_PICTURES"));
  picture.save(QStringLiteral("%1/%2.png").arg(folder, name));
}

}  // namespace tests
