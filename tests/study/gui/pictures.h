#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

namespace tests {

/// With PALPATE_PICTURES=FOLDER saves how a window looks in every theme as NAME-THEME.png, and on a
/// large screen as NAME-large.png, for people to look at. Otherwise nothing happens.
void photographInAllThemes(QWidget& window, const QString& name);

/// The same of a picture: with PALPATE_PICTURES=FOLDER saves it as NAME.png.
void keepPicture(const QImage& picture, const QString& name);

}  // namespace tests
