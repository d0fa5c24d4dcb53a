#pragma once

#include <set>

#include <QString>
#include <QWidget>

namespace tests {

/// Every word in a window that somebody could come upon: texts, titles, cells, lists, tool tips,
/// object names, and what a screen reader is told (names, descriptions, values, help).
std::set<QString> wordsIn(QWidget& window);

}  // namespace tests
