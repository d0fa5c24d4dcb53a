#pragma once

#include <exception>

#include <QWidget>

#include "study/gui/widgets/messages.h"

namespace study::gui {

/// Shows the message about @p topic, with what @p error says.
void showFailure(QWidget* parent, MessageTopic topic, const std::exception& error);

/// Runs @p action. If it throws, shows the message about @p topic with the error's own, and
/// returns false.
///
/// Exceptions must not cross Qt's event loop, so slots call this for code that may throw.
template <typename Action>
bool attempt(QWidget* parent, MessageTopic topic, Action&& action) {
  try {
    action();
    return true;
  } catch (const std::exception& error) {
    showFailure(parent, topic, error);
    return false;
  }
}

}  // namespace study::gui
