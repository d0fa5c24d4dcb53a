#pragma once

#include <QString>

namespace study::gui {

/// A text for participants in which each blank says that it is one: "[[contact]]" becomes
/// "[[contact: to be filled in]]". Labels mark the brackets (textLabel()).
QString withBlanksNamed(const QString& text);

}  // namespace study::gui
