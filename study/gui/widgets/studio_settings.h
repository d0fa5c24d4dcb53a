#pragma once

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QString>

namespace study::gui {

/// The settings of the studio on this computer: recent studies and written documents, theme and
/// language, the folder of protocols, and whether the tour was seen. They contain nothing about
/// participants.
inline QSettings studioSettings() {
  return QSettings(
      QSettings::IniFormat,
      QSettings::UserScope,
      QStringLiteral("palpate"),
      QStringLiteral("studio"));
}

/// The folder in which the user last chose or saved a protocol; at first the user's own, where new
/// studies are offered as well.
inline QString protocolFolder() {
  return studioSettings().value(QStringLiteral("protocolFolder"), QDir::homePath()).toString();
}
inline void rememberProtocolFolder(const QString& file) {
  studioSettings().setValue(QStringLiteral("protocolFolder"), QFileInfo(file).absolutePath());
}

}  // namespace study::gui
