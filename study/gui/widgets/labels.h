#pragma once

#include <string>
#include <string_view>

#include <QLabel>
#include <QString>
#include <QWidget>

#include "protocols/model/protocol.h"

namespace study::gui {

/// Words from below the windows, as Qt has them.
QString asText(std::string_view words);
/// "cuts" as "Cuts".
QString capitalised(const QString& words);
/// The title of a cohort; its id where only an earlier version of the protocol had it.
QString cohortTitle(const protocols::Protocol& protocol, const std::string& id);

/// Labels of a page, as the theme draws them.
QLabel* titleLabel(const QString& text, QWidget* parent);
QLabel* bodyLabel(const QString& text, QWidget* parent);
QLabel* quietLabel(const QString& text, QWidget* parent);
QLabel* hugeLabel(const QString& text, QWidget* parent);

/// Lets a label be drawn as another: "good", "warn", "resting", "bad", "quiet", "heading".
void setRole(QLabel& label, const char* role);

}  // namespace study::gui
