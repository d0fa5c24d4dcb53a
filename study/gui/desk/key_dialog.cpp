#include "study/gui/desk/key_dialog.h"

#include "study/gui/desk/study_dialogs.h"
#include "study/gui/widgets/attempt.h"
#include "study/session/study_key.h"

namespace study::gui {

KeyDialog::KeyDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Key of the study"),
          tr("Which condition an alternative was is sealed in the study's folder; this account "
             "keeps "
             "the key. Save a copy before the first participant, and keep it apart: without the "
             "key "
             "nobody can say which condition was which. Another account or computer needs it to go "
             "on with sessions, and to export or report them."),
          tr("Save"),
          parent),
      folder_(study.folder),
      wanted_(new QComboBox(this)),
      reason_(new QLineEdit(this)),
      target_(new PathField(PathField::Kind::NewFile, tr("Key"), tr("Keys (*.txt)"), this)),
      source_(new PathField(PathField::Kind::ExistingFile, tr("Key"), tr("Keys (*.txt)"), this)) {
  wanted_->setObjectName(QStringLiteral("wanted"));
  wanted_->setAccessibleName(tr("What to do"));
  wanted_->addItem(tr("Save a copy of the key"), static_cast<int>(Wanted::Save));
  wanted_->addItem(tr("Take the key from a file"), static_cast<int>(Wanted::Take));
  reason_->setObjectName(QStringLiteral("reason"));
  reason_->setAccessibleName(tr("Reason"));
  reason_->setPlaceholderText(tr("who gets it: it goes into the audit trail"));
  form().addRow(tr("What"), wanted_);
  form().addRow(tr("Reason"), reason_);
  form().addRow(tr("New file"), target_);
  form().addRow(tr("File of the key"), source_);
  connect(wanted_, &QComboBox::currentIndexChanged, this, &KeyDialog::updateChoices);
  connect(reason_, &QLineEdit::textChanged, this, &KeyDialog::updateChoices);
  connect(source_, &PathField::pathChanged, this, &KeyDialog::updateChoices);
  target_->setPath(newPathBeside(folder_, QStringLiteral("key"), QStringLiteral(".txt")));
  findChild<QTextBrowser*>(QStringLiteral("more"))->setAccessibleName(tr("Where the key is"));
  showState();
  updateChoices();
}

KeyDialog::Wanted KeyDialog::wanted() const {
  return static_cast<Wanted>(wanted_->currentData().toInt());
}

void KeyDialog::showState() {
  attempt(this, [&] {
    SystemClock clock;
    auto study = Study::open(folder_, clock, storage::Database::Access::ReadOnly);
    const auto words = sealInWords(study);
    state_ = words.empty() ? tr("Nothing is sealed.")
                           : tr("Conditions: %1.").arg(QString::fromStdString(words));
    showDetails(state_);
    const bool needsKey = study.isSealed() && !study.hasKey();
    wanted_->setCurrentIndex(
        wanted_->findData(static_cast<int>(needsKey ? Wanted::Take : Wanted::Save)));
  });
}

void KeyDialog::updateChoices() {
  const bool saves = wanted() == Wanted::Save;
  form().setRowVisible(reason_, saves);
  form().setRowVisible(target_, saves);
  form().setRowVisible(source_, !saves);
  go().setText(saves ? tr("Save") : tr("Take"));
  go().setEnabled(saves ? !reason_->text().trimmed().isEmpty() : !source_->path().isEmpty());
}

void KeyDialog::work() {
  const auto target = target_->path();
  const bool saves = wanted() == Wanted::Save;
  const bool isDone = attempt(this, [&] {
    SystemClock clock;
    auto study = Study::open(folder_, clock);
    if (saves) {
      exportKey(study, target.toStdString(), reason_->text().trimmed().toStdString());
    } else {
      importKey(study, source_->path().toStdString());
    }
  });
  if (!isDone) return clear();
  showState();
  if (!saves) return showOutcome(Outcome::Good, tr("This account has the key now."), state_);
  target_->setPath(newPathBeside(folder_, QStringLiteral("key"), QStringLiteral(".txt")));
  showOutcome(
      Outcome::Good,
      tr("Key saved: %1. Keep it apart from the study and its backups.").arg(target),
      state_);
}

}  // namespace study::gui
