#include "study/gui/desk/key_question.h"

#include <QInputDialog>
#include <QString>

#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/session/study.h"

namespace study::gui {

void askForKeyOf(const std::string& folder, QWidget* parent) {
  attempt(parent, [&] {
    SystemClock clock;
    auto study = Study::open(folder, clock, storage::Database::Access::ReadOnly);
    if (!study.isSealed() || study.hasKey() || !study.hasPassphrase()) return;
    auto label = spoken(
        "The conditions of this study are sealed, and this account does not have the key.\n"
        "Passphrase of the study:");
    for (;;) {
      bool isGiven = false;
      const auto typed = QInputDialog::getText(
          parent, spoken("Sealed study"), label, QLineEdit::Password, {}, &isGiven);
      if (!isGiven || study.unlock(typed.toStdString())) return;
      label = spoken("Wrong passphrase. Passphrase of the study:");
    }
  });
}

}  // namespace study::gui
