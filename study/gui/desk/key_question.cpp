#include "study/gui/desk/key_question.h"

#include <functional>

#include <QString>

#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/message_box.h"
#include "study/session/study.h"

namespace study::gui {
namespace {

/// Asks for a passphrase until @p opens returns true for it or the dialog is closed.
void askUntilRight(
    QWidget* parent, MessageTopic topic, const std::function<bool(const std::string&)>& opens) {
  QString why;
  for (;;) {
    const auto typed = askForText(parent, topic, {}, {}, why);
    if (!typed || opens(typed->toStdString())) return;
    why = deskText("Wrong passphrase.");
  }
}

}  // namespace

void askForPassphraseOfKey(const std::string& folder, QWidget* parent) {
  attempt(parent, MessageTopic::StudyNotOpened, [&] {
    auto study = Study::open(folder, storage::Database::Access::ReadOnly);
    if (!study.isSealed() || study.hasKey() || !study.hasPassphrase()) return;
    askUntilRight(parent, MessageTopic::StudyPassphrase, [&](const std::string& typed) {
      return study.unlock(typed);
    });
  });
}

void askForPassphraseOfNames(const std::string& folder, QWidget* parent) {
  attempt(parent, MessageTopic::StudyNotOpened, [&] {
    auto study = Study::open(folder, storage::Database::Access::ReadOnly);
    if (!study.identities().isLocked()) return;
    askUntilRight(parent, MessageTopic::NamesPassphrase, [&](const std::string& typed) {
      return study.unlockNames(typed);
    });
  });
}

}  // namespace study::gui
