#pragma once

#include <optional>

#include <QString>
#include <QWidget>

namespace study::gui {

/// Asks the operator for a new PIN, twice; nothing where they think better of it.
std::optional<QString> askForNewPin(QWidget* parent);

}  // namespace study::gui
