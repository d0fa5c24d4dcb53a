#pragma once

#include <string>

class QWidget;

namespace study::gui {

/// If the conditions of a study are sealed, this account does not have the key, and the key is
/// protected by a passphrase: asks for the passphrase until it is right or the dialog is closed.
/// The key is kept in memory until the program ends. Without the key, everything that needs no key
/// is possible.
void askForPassphraseOfKey(const std::string& folder, QWidget* parent);

/// Asks in the same way for the passphrase of the participants' names (docs/decisions/0062).
/// Without it no session can be begun or resumed.
void askForPassphraseOfNames(const std::string& folder, QWidget* parent);

}  // namespace study::gui
