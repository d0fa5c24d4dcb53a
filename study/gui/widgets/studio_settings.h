#pragma once

#include <QSettings>
#include <QString>

namespace study::gui {

/// The settings of the studio on this computer: recent studies, the theme, and whether the tour was
/// seen. They contain nothing about participants.
inline QSettings studioSettings() {
  return QSettings(
      QSettings::IniFormat,
      QSettings::UserScope,
      QStringLiteral("palpate"),
      QStringLiteral("studio"));
}

}  // namespace study::gui
