#include "study/gui/desk/key_question.h"

#include <functional>

#include <QInputDialog>
#include <QString>

#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/session/study.h"

namespace study::gui {
namespace {

/// Asks for a passphrase until @p opens returns true for it or the dialog is closed.
void ask(
    QWidget* parent,
    const QString& title,
    const QString& why,
    const QString& question,
    const std::function<bool(const std::string&)>& opens) {
  auto label = why + "\n" + question;
  for (;;) {
    bool isGiven = false;
    const auto typed =
        QInputDialog::getText(parent, title, label, QLineEdit::Password, {}, &isGiven);
    if (!isGiven || opens(typed.toStdString())) return;
    label = deskText("Wrong passphrase.") + " " + question;
  }
}

}  // namespace

void askForKeyOf(const std::string& folder, QWidget* parent) {
  attempt(parent, [&] {
    auto study = Study::open(folder, storage::Database::Access::ReadOnly);
    if (!study.isSealed() || study.hasKey() || !study.hasPassphrase()) return;
    ask(parent,
        deskText("Sealed study"),
        deskText(
            "The conditions of this study are sealed, and this account does not have the key."),
        deskText("Passphrase of the study:"),
        [&](const std::string& typed) { return study.unlock(typed); });
  });
}

void askForNamesOf(const std::string& folder, QWidget* parent) {
  attempt(parent, [&] {
    auto study = Study::open(folder, storage::Database::Access::ReadOnly);
    if (!study.identities().isLocked()) return;
    ask(parent,
        deskText("Sealed names"),
        deskText("The names of participants are sealed. Sessions need their passphrase."),
        deskText("Passphrase of names:"),
        [&](const std::string& typed) { return study.unlockNames(typed); });
  });
}

}  // namespace study::gui
