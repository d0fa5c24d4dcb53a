#include "study/gui/widgets/theme_choice.h"

#include <QActionGroup>
#include <QPalette>

#include "study/gui/widgets/studio_settings.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr const char* kThemeKey = "theme";

ThemeName& desktopsTheme() noexcept {
  static ThemeName name = ThemeName::Light;
  return name;
}

void wearChosen(QApplication& application) {
  const auto chosen = themeCalled(studioSettings().value(QLatin1String(kThemeKey)).toString());
  applyTheme(application, chosen.value_or(desktopsTheme()));
}

void addChoice(QMenu& menu, QActionGroup* group, const QString& words, const QString& stored) {
  auto* action = menu.addAction(words);
  action->setObjectName(QStringLiteral("theme-") + stored);
  action->setCheckable(true);
  action->setChecked(studioSettings().value(QLatin1String(kThemeKey)).toString() == stored);
  group->addAction(action);
  QObject::connect(action, &QAction::triggered, action, [stored] {
    studioSettings().setValue(QLatin1String(kThemeKey), stored);
    wearChosen(*qobject_cast<QApplication*>(QApplication::instance()));
  });
}

}  // namespace

void applyChosenTheme(QApplication& application) {
  const auto palette = QApplication::palette();
  const bool isDark =
      palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
  desktopsTheme() = isDark ? ThemeName::Dark : ThemeName::Light;
  wearChosen(application);
}

void addThemesTo(QMenu& menu) {
  auto* group = new QActionGroup(&menu);
  addChoice(menu, group, QObject::tr("As the desktop"), {});
  addChoice(menu, group, QObject::tr("Light"), nameOf(ThemeName::Light));
  addChoice(menu, group, QObject::tr("Dark"), nameOf(ThemeName::Dark));
  addChoice(menu, group, QObject::tr("High contrast"), nameOf(ThemeName::HighContrast));
}

}  // namespace study::gui
