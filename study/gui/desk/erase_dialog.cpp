#include "study/gui/desk/erase_dialog.h"

#include <map>
#include <set>

#include <QFileInfo>

#include "study/gui/desk/recent_studies.h"
#include "study/gui/desk/study_dialogs.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/background_task.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/model/new_file.h"
#include "study/model/storage_error.h"
#include "study/report/pdf_report.h"
#include "study/session/unblinding.h"
#include "study/words/words.h"

namespace study::gui {
namespace {

constexpr int kSessionsRole = Qt::UserRole + 1;  ///< what tells a participant apart, in words

/// A participant that can be erased.
struct Person {
  QStringList names;     ///< that were given
  QStringList dates;     ///< of each session
  QStringList sessions;  ///< "Surgeons, 2026-03-09, completed"
};

/// By code.
std::map<std::string, Person> peopleIn(Study& study) {
  constexpr int kDate = 10;  // letters of "2026-03-09", at the beginning of a time
  std::map<std::string, Person> all;
  std::set<std::string> erasable;
  std::set<std::string> simulated;
  for (const auto& row : study.sessions().all()) {
    if (row.runMode == RunMode::Simulated) simulated.insert(row.participant);
    if (row.state != SessionState::Erased) erasable.insert(row.participant);
    const auto date = localTime(row.startedUtc).left(kDate);
    const QStringList session{
        cohortTitle(study.protocol().protocol, row.cohort), date, statusInWords(row.state)};
    all[row.participant].dates << date;
    all[row.participant].sessions << session.join(QStringLiteral(", "));
  }
  if (!study.identities().isLocked()) {
    const auto shown = study.identities().names();
    recordNamesShown(study, shown.size());
    for (const auto& name : shown) {
      all[name.participant].names << QString::fromStdString(name.text);
      erasable.insert(name.participant);  // also one whose answers are erased
    }
  }
  std::erase_if(all, [&](const auto& each) {
    return simulated.contains(each.first) || !erasable.contains(each.first);
  });
  return all;
}

std::string certificateContent(
    const report::ErasureCertificate& certificate, const words::Words& words, const QString& path) {
  const auto ending = QFileInfo(path).suffix();
  if (ending == QLatin1String("txt")) return asText(certificate, words);
  const auto html = asHtml(certificate, words);
  return ending == QLatin1String("pdf") ? report::asPdf(html, certificate.title) : html;
}

/// Erases from the study, and from @p copy unless that is empty.
report::ErasureCertificate erase(
    const std::string& folder, const ErasureRequest& request, const std::string& copy) {
  SystemClock clock;
  auto study = Study::open(folder, clock);
  report::ErasureCertificate certificate{.title = study.protocol().protocol.study.title};
  certificate.report = study::erase(study, request);
  if (!copy.empty()) {
    certificate.copies.push_back(eraseFromCopy(
        copy, certificate.report.listed, certificate.report.texts, clock, knownCopies(study)));
  }
  certificate.notErasedFrom = copiesNotErased(study, certificate.copies, request.participant);
  return certificate;
}

}  // namespace

EraseDialog::EraseDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Erase a participant"),
          tr("Deletes the data of a participant of “%1” permanently. The audit trail stays valid "
             "and records when and why; results no longer include this person.")
              .arg(QString::fromStdString(study.title)),
          tr("Erase"),
          parent),
      folder_(study.folder),
      participant_(new QComboBox(this)),
      level_(new QComboBox(this)),
      code_(new QLineEdit(this)),
      copy_(new PathField(PathField::Kind::ExistingFolder, tr("Backup or export"), {}, this)),
      certificate_(new PathField(
          PathField::Kind::NewFile,
          tr("Certificate"),
          tr("Certificates (*.pdf *.html *.txt)"),
          this)),
      language_(new QComboBox(this)),
      reseal_(new QCheckBox(tr("Seal the audit trail of an older release first"), this)) {
  participant_->setObjectName(QStringLiteral("participant"));
  level_->setAccessibleName(tr("What is erased"));
  level_->addItem(tr("Names, answers and recordings"), QStringLiteral("all"));
  level_->addItem(tr("Answers and recordings only"), QStringLiteral("answers"));
  level_->addItem(tr("Names and signature only"), QStringLiteral("identity"));
  code_->setObjectName(QStringLiteral("code"));
  code_->setAccessibleName(tr("Type the code"));
  language_->setObjectName(QStringLiteral("language"));
  addLanguages(*language_, words::languages());
  chooseLanguage(*language_, deskLanguage());
  runButton().setProperty("role", QStringLiteral("danger"));
  reseal_->setObjectName(QStringLiteral("reseal"));
  reseal_->setToolTip(tr(
      "Once for the whole study. States of the audit trail that were noted earlier are no longer "
      "found in it. Back up the study first."));
  copy_->startIn(folderBeside(folder_));
  copy_->setHint(tr("optional"));
  form().addRow(tr("Participant"), participant_);
  sessions_ = addHint({});
  sessions_->setObjectName(QStringLiteral("sessions"));
  form().addRow(tr("What"), level_);
  addReason(
      tr("Reason"), [this] { updateButton(); }, tr("without names: it stays in the audit trail"));
  form().addRow(tr("Also from a backup or export"), copy_);
  form().addRow(tr("Certificate"), certificate_);
  form().addRow(tr("Language of the certificate"), language_);
  form().addRow(QString(), reseal_);
  form().addRow(tr("Type the code to confirm"), code_);
  connect(code_, &QLineEdit::textChanged, this, &EraseDialog::updateButton);
  connect(participant_, &QComboBox::currentIndexChanged, this, &EraseDialog::updateButton);
  fillIn();
}

void EraseDialog::fillIn() {
  participant_->clear();
  code_->clear();
  attempt(this, MessageTopic::ParticipantsNotListed, [&] {
    auto study = Study::open(folder_, storage::Database::Access::ReadOnly);
    for (const auto& [id, person] : peopleIn(study)) {
      const auto code = QString::fromStdString(id);
      const auto words = QStringList(code) + person.names + person.dates;
      participant_->addItem(words.join(QStringLiteral(" · ")), code);
      participant_->setItemData(
          participant_->count() - 1, person.sessions.join(QStringLiteral("; ")), kSessionsRole);
    }
    form().setRowVisible(reseal_, !remarkOnUnsealedTrail(study).empty());
  });
  const bool isAnyone = participant_->count() > 0;
  showNotice(
      Mark::Warning,
      isAnyone ? QString()
               : tr("There is nobody to erase: no person has taken part, or all are erased. "
                    "Simulated participants are no people."));
  for (int row = 0; row < form().rowCount() && !isAnyone; ++row) form().setRowVisible(row, false);
  certificate_->setPath(
      unusedPathBeside(folder_, QStringLiteral("erasure"), QStringLiteral(".pdf")));
  updateButton();
}

void EraseDialog::updateButton() {
  const auto code = participant_->currentData().toString();
  sessions_->setText(participant_->currentData(kSessionsRole).toString());
  if (code.isEmpty()) return setDisabledReason(tr("No participant can be erased."));
  qobject_cast<QLabel*>(form().labelForField(code_))->setText(tr("Type %1 to confirm").arg(code));
  setDisabledReason(
      reason().empty()                  ? tr("Give a reason.")
      : code_->text().trimmed() != code ? tr("Type %1 to confirm.").arg(code)
                                        : QString());
}

void EraseDialog::work() {
  const auto path = certificate_->path();
  try {
    if (!path.isEmpty()) requireNewFile(path.toStdString());
  } catch (const storage::StorageError& error) {
    return showOutcome(
        Outcome::Bad,
        tr("Nothing was erased: the certificate cannot be saved."),
        {{QString::fromUtf8(error.what())}});
  }
  const ErasureRequest request{
      .participant = participant_->currentData().toString().toStdString(),
      .level = storage::erasureLevelNamed(level_->currentData().toString().toStdString()).value(),
      .reason = reason(),
      .resealsTrail = reseal_->isChecked()};
  const auto copy = copy_->path().toStdString();
  const auto words = words::wordsIn(language_->currentData().toString().toStdString());
  report::ErasureCertificate certificate;
  std::string whyNotSaved;
  const bool isDone = BackgroundTask::run(
      this,
      tr("Erasing"),
      MessageTopic::ParticipantNotErased,
      [&](const Progress&) {
        certificate = erase(folder_, request, copy);
        try {
          if (!path.isEmpty())
            writeNewFile(path.toStdString(), certificateContent(certificate, words, path));
        } catch (const std::exception& error) {
          whyNotSaved = error.what();
        }
      },
      BackgroundTask::Cancelling::Impossible);
  if (!isDone) return clear();
  const auto certified = QString::fromStdString(asText(certificate, words));
  const auto code = QString::fromStdString(request.participant);
  if (!whyNotSaved.empty()) {
    showOutcome(
        Outcome::Warning,
        tr("%1 is erased, but the certificate was not saved.").arg(code),
        {{QString::fromStdString(whyNotSaved) + QStringLiteral("\n\n") + certified}});
  } else if (!certificate.isClean()) {
    showOutcome(
        Outcome::Warning, tr("%1 is erased, but some data are left.").arg(code), {{certified}});
  } else if (path.isEmpty()) {
    showOutcome(Outcome::Good, tr("%1 is erased.").arg(code), {{certified}});
  } else {
    rememberDocument(QString::fromStdString(folder_), path);
    showWrittenFile(path, tr("%1 is erased. Certificate saved: %2").arg(code, path), {{certified}});
  }
  fillIn();
}

}  // namespace study::gui
