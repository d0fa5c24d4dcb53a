#pragma once

#include <QString>

namespace study::gui {

/// A text for participants in which each blank says that it is one: "[[contact]]" becomes
/// "[[contact: to be filled in]]". Labels mark the brackets (textLabel()).
QString withBlanksNamed(const QString& text);

/// A text in which no line ends between a number and the word that it belongs to, as in "31 March
/// 2027", or between a title and a name.
QString withUnbrokenNumbers(const QString& text);

}  // namespace study::gui
