#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

namespace tests {

/// Saves pictures of a window as NAME-THEME.png in every theme and as NAME-large.png on a large
/// screen, if PALPATE_PICTURES=FOLDER is set. Otherwise does nothing.
void photographInAllThemes(QWidget& window, const QString& name);

/// Saves a picture as NAME.png if PALPATE_PICTURES=FOLDER is set.
void keepPicture(const QImage& picture, const QString& name);

}  // namespace tests
