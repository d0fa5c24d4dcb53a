#pragma once

#include <exception>

#include <QMessageBox>
#include <QWidget>

#include "study/gui/widgets/desk_language.h"

namespace study::gui {

/// Runs @p action. If it throws, shows the error's message and returns false.
///
/// Exceptions must not cross Qt's event loop, so slots call this for code that may throw.
template <typename Action>
bool attempt(QWidget* parent, Action&& action) {
  try {
    action();
    return true;
  } catch (const std::exception& error) {
    QMessageBox::warning(parent, deskText("Error"), QString::fromUtf8(error.what()));
    return false;
  }
}

}  // namespace study::gui
