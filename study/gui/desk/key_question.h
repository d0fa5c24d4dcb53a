#pragma once

#include <string>

class QWidget;

namespace study::gui {

/// If the conditions of a study are sealed, this account has not the key, and a passphrase opens
/// it: asks for the passphrase until it is right or the window is closed. The key is held until the
/// program ends. Without it everything that needs no key is possible.
void askForKeyOf(const std::string& folder, QWidget* parent);

/// The same for names (docs/decisions/0062). Without their passphrase no session goes on.
void askForNamesOf(const std::string& folder, QWidget* parent);

}  // namespace study::gui
