#pragma once

#include <QString>
#include <QWidget>

namespace study::gui {

/// Opens a window with a bone (a packing, coloured by density) or a knee (an anatomy as OBJ,
/// together with the punch), drawn as in a trial.
/// @throws UserError  with a message for the user, if the file contains neither.
QWidget* openShapeWindow(const QString& path, QWidget* parent);

/// Open a window with the built-in bone or knee.
QWidget* openBuiltInBone(QWidget* parent);
QWidget* openBuiltInKnee(QWidget* parent);

/// Asks for a file and opens it. Shows a message if that fails.
void chooseAndOpenShape(QWidget* parent);

}  // namespace study::gui
