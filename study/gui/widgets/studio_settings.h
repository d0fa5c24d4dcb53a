#pragma once

#include <QSettings>
#include <QString>

namespace study::gui {

/// What the studio remembers from one start to the next: recent studies, the theme, that the tour
/// was seen. Nothing about a participant.
inline QSettings studioSettings() {
  return QSettings(
      QSettings::IniFormat,
      QSettings::UserScope,
      QStringLiteral("palpate"),
      QStringLiteral("studio"));
}

}  // namespace study::gui
