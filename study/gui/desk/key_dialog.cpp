#include "study/gui/desk/key_dialog.h"

#include "study/gui/desk/study_dialogs.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/session/study_key.h"

namespace study::gui {

KeyDialog::KeyDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Key of the study"),
          tr("Only the key tells which condition an alternative was. Save a copy of it, and keep "
             "it apart from the study: without a key the alternatives can never be named again."),
          tr("Save"),
          parent),
      folder_(study.folder),
      task_(new QComboBox(this)),
      target_(new PathField(PathField::Kind::NewFile, tr("Key"), tr("Keys (*.txt)"), this)),
      source_(new PathField(PathField::Kind::ExistingFile, tr("Key"), tr("Keys (*.txt)"), this)),
      passphrase_(new QLineEdit(this)),
      passphraseAgain_(new QLineEdit(this)) {
  task_->setObjectName(QStringLiteral("wanted"));
  task_->setAccessibleName(tr("What to do"));
  task_->addItem(tr("Save a copy of the key"), static_cast<int>(KeyTask::Save));
  task_->addItem(tr("Import the key from a file"), static_cast<int>(KeyTask::Take));
  task_->addItem(tr("Put names behind a passphrase"), static_cast<int>(KeyTask::SealNames));
  passphrase_->setObjectName(QStringLiteral("passphrase"));
  passphraseAgain_->setObjectName(QStringLiteral("again"));
  passphrase_->setPlaceholderText(
      tr("write it down: without it the names can never be read again"));
  for (auto* field : {passphrase_, passphraseAgain_}) {
    field->setEchoMode(QLineEdit::Password);
    connect(field, &QLineEdit::textChanged, this, &KeyDialog::updateChoices);
  }
  form().addRow(tr("Action"), task_);
  addReason(
      tr("Reason"), [this] { updateChoices(); }, tr("why, and who gets it (kept in the record)"));
  form().addRow(tr("New file"), target_);
  form().addRow(tr("File of the key"), source_);
  form().addRow(tr("Passphrase"), passphrase_);
  form().addRow(tr("The same again"), passphraseAgain_);
  connect(task_, &QComboBox::currentIndexChanged, this, &KeyDialog::updateChoices);
  connect(source_, &PathField::pathChanged, this, &KeyDialog::updateChoices);
  sameDisk_ = addHint(tr("This is the disk of the study: who gets it gets the key as well."));
  setRole(*sameDisk_, "warn");
  connect(target_, &PathField::pathChanged, this, &KeyDialog::updateChoices);
  source_->startIn(folderBeside(folder_));
  target_->startIn(pathApart(folder_, QStringLiteral("key"), QStringLiteral(".txt")));
  showState();
  updateChoices();
}

KeyDialog::KeyTask KeyDialog::chosenTask() const {
  return static_cast<KeyTask>(task_->currentData().toInt());
}

void KeyDialog::showState() {
  attempt(this, MessageTopic::KeyNotRead, [&] {
    auto study = Study::open(folder_, storage::Database::Access::ReadOnly);
    const auto words = keyStatusText(study);
    const bool needsKey = study.isSealed() && !study.hasKey();
    showNotice(
        needsKey || hasOnlyCopyOfKey(study) ? Mark::Warning : Mark::None,
        words.empty() ? tr("Nothing is sealed.") : tr("Conditions: %1.").arg(deskText(words)));
    task_->setCurrentIndex(
        task_->findData(static_cast<int>(needsKey ? KeyTask::Take : KeyTask::Save)));
  });
}

void KeyDialog::updateChoices() {
  const bool saves = chosenTask() == KeyTask::Save;
  const bool takes = chosenTask() == KeyTask::Take;
  const bool seals = chosenTask() == KeyTask::SealNames;
  showReason(!takes);
  form().setRowVisible(target_, saves);
  form().setRowVisible(sameDisk_, saves && isOnDiskOf(folder_, target_->path()));
  form().setRowVisible(source_, takes);
  form().setRowVisible(passphrase_, seals);
  form().setRowVisible(passphraseAgain_, seals);
  runButton().setText(saves ? tr("Save") : takes ? tr("Import") : tr("Set"));
  const bool isTypedTwice =
      !passphrase_->text().isEmpty() && passphrase_->text() == passphraseAgain_->text();
  setDisabledReason(
      takes              ? (source_->path().isEmpty() ? tr("Choose the file.") : QString())
      : reason().empty() ? tr("Give a reason.")
      : saves            ? (target_->path().isEmpty() ? tr("Choose a new file.") : QString())
      : isTypedTwice     ? QString()
                         : tr("Type the same passphrase twice."));
  fit();
}

void KeyDialog::work() {
  if (chosenTask() == KeyTask::Save) return saveKey();
  if (chosenTask() == KeyTask::SealNames) return sealNames();
  const bool isAccepted = attempt(this, MessageTopic::KeyNotTaken, [&] {
    auto study = Study::open(folder_);
    importKey(study, source_->path().toStdString());
  });
  if (!isAccepted) return clear();
  showState();
  showOutcome(Outcome::Good, tr("This account has the key now."));
}

void KeyDialog::saveKey() {
  const auto target = target_->path();
  const bool isSaved = attempt(this, MessageTopic::KeyNotSaved, [&] {
    auto study = Study::open(folder_);
    exportKey(study, target.toStdString(), reason());
  });
  if (!isSaved) return clear();
  showState();
  target_->setPath(QString());
  showWrittenFile(
      target, tr("Key saved: %1. Keep it apart from the study and its backups.").arg(target));
}

void KeyDialog::sealNames() {
  const bool isSealed = attempt(this, MessageTopic::NamesNotSealed, [&] {
    auto study = Study::open(folder_);
    setPassphraseOfNames(study, passphrase_->text().toStdString(), reason());
  });
  if (!isSealed) return clear();
  passphrase_->clear();
  passphraseAgain_->clear();
  showState();
  showOutcome(
      Outcome::Good,
      tr("Names are behind the passphrase now. Sessions ask for it; it cannot be recovered."));
}

}  // namespace study::gui
