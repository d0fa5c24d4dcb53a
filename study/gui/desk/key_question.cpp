#include "study/gui/desk/key_question.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QString>

#include "study/gui/widgets/attempt.h"
#include "study/session/study.h"

namespace study::gui {
namespace {

QString inWords(const char* text) {
  return QCoreApplication::translate("KeyQuestion", text);
}

}  // namespace

void askForKeyOf(const std::string& folder, QWidget* parent) {
  attempt(parent, [&] {
    SystemClock clock;
    auto study = Study::open(folder, clock, storage::Database::Access::ReadOnly);
    if (!study.isSealed() || study.hasKey() || !study.hasPassphrase()) return;
    auto label = inWords(QT_TRANSLATE_NOOP(
        "KeyQuestion",
        "The conditions of this study are sealed, and this account has not the key.\nPassphrase of "
        "the study:"));
    for (;;) {
      bool isGiven = false;
      const auto typed = QInputDialog::getText(
          parent,
          inWords(QT_TRANSLATE_NOOP("KeyQuestion", "Sealed study")),
          label,
          QLineEdit::Password,
          {},
          &isGiven);
      if (!isGiven || study.unlock(typed.toStdString())) return;
      label = inWords(
          QT_TRANSLATE_NOOP("KeyQuestion", "This is not the passphrase. Passphrase of the study:"));
    }
  });
}

}  // namespace study::gui
