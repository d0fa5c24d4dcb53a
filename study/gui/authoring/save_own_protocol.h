#pragma once

#include <string>

#include <QString>
#include <QWidget>

#include "protocols/model/loaded_protocol.h"

namespace study::gui {

/// Writes a protocol's text to a file, or leaves the file as it is.
/// @throws UserError  if it cannot be written.
void writeProtocol(const QString& file, const std::string& text);

/// Asks for a title and a file, and saves a shipped protocol there as one of the user's own: with
/// that title, and the file's name as its id.
/// @return the file; empty if nothing was saved: the user cancelled, or has been told why.
QString saveAsOwn(const protocols::LoadedProtocol& shipped, QWidget* parent);

}  // namespace study::gui
