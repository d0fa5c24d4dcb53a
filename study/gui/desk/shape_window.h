#pragma once

#include <QString>
#include <QWidget>

namespace study::gui {

/// Opens a window with a bone (a packing, in colours that say how hard it is) or a knee (an anatomy
/// as OBJ, with the punch in it) as trials show them.
/// @throws questionnaires::Error  in words, if the file holds neither.
QWidget* openShape(const QString& path, QWidget* parent);

/// Asks for such a file, and opens it or says what is wrong with it.
void askForShape(QWidget* parent);

}  // namespace study::gui
