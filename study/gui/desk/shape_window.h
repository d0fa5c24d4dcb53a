#pragma once

#include <QString>
#include <QWidget>

namespace study::gui {

/// Opens a window with a bone (a packing, coloured by density) or a knee (an anatomy as OBJ,
/// together with the punch), drawn as in a trial.
/// @throws UserError  with a message for the user, if the file holds neither.
QWidget* openShape(const QString& path, QWidget* parent);

/// The same with the bone or the knee that the program has built in.
QWidget* openBuiltInBone(QWidget* parent);
QWidget* openBuiltInKnee(QWidget* parent);

/// Asks for a file and opens it. Shows a message if that fails.
void chooseAndOpenShape(QWidget* parent);

}  // namespace study::gui
