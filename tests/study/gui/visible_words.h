#pragma once

#include <set>

#include <QString>
#include <QWidget>

namespace tests {

/// Every text in a window that a person could find: texts, titles, cells, lists, tool tips, object
/// names, and a screen reader's names, descriptions, values and help.
std::set<QString> wordsIn(QWidget& window);

}  // namespace tests
