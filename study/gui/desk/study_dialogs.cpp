#include "study/gui/desk/study_dialogs.h"

#include <algorithm>
#include <filesystem>

#include <QDate>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QStorageInfo>

#include "study/gui/desk/recent_studies.h"
#include "study/gui/desk/report_work.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/background_task.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/message_box.h"
#include "study/session/backup.h"
#include "study/session/unblinding.h"
#include "study/words/words.h"

namespace study::gui {
namespace {

constexpr int kCountRole = Qt::UserRole + 1;  ///< number of sessions of a mode

}  // namespace

std::vector<Note> notesOf(const Verification& verification) {
  std::vector<Note> notes;
  for (const auto& check : verification.checks) {
    auto& note = notes.emplace_back(Note{
        capitalised(deskText(check.what)),
        !check.problems.empty() ? Mark::Bad
        : check.remarks.empty() ? Mark::Good
                                : Mark::None});
    for (const auto& problem : check.problems) note.details << QString::fromStdString(problem);
    for (const auto& remark : check.remarks) note.details << QString::fromStdString(remark);
  }
  return notes;
}

QComboBox* makeRunModeBox(const StudySummary& study, QWidget* parent) {
  auto* choice = new QComboBox(parent);
  choice->setAccessibleName(QObject::tr("Which sessions"));
  for (const auto mode : {RunMode::Live, RunMode::Pilot, RunMode::Simulated}) {
    const int count = countIn(study.sessions, mode);
    const auto name = nameOf(mode);
    choice->addItem(
        QString::fromStdString(translated(
            count == 1 ? "{} ({} session)" : "{} ({} sessions)", translated(name), count)),
        static_cast<int>(mode));
    choice->setItemData(choice->count() - 1, count, kCountRole);
  }
  choice->setCurrentIndex(choice->findData(static_cast<int>(defaultRunMode(study))));
  return choice;
}

bool hasSessions(const QComboBox& choice) {
  return choice.currentData(kCountRole).toInt() > 0;
}

QString noSessionsText() {
  return QObject::tr("There are no such sessions yet.");
}

RunMode chosenMode(const QComboBox& choice) {
  return static_cast<RunMode>(choice.currentData().toInt());
}

/// "my-study-backup-2026-11-23"
static QString nameToday(const std::string& folder, const QString& what) {
  const QFileInfo study(QDir::cleanPath(QString::fromStdString(folder)));
  return study.fileName() + QLatin1Char('-') + what + QLatin1Char('-') +
         QDate::currentDate().toString(Qt::ISODate);
}

QString unusedPathBeside(const std::string& folder, const QString& what, const QString& extension) {
  return unusedPath(QDir(folderBeside(folder)).filePath(nameToday(folder, what)), extension);
}

QString folderBeside(const std::string& folder) {
  const QFileInfo beside(QFileInfo(QDir::cleanPath(QString::fromStdString(folder))).absolutePath());
  return beside.isWritable() && !beside.isRoot() ? beside.filePath() : documentsFolder();
}

QString diskApartFrom(const QByteArray& device, const std::vector<MountedDisk>& disks) {
  const auto isApart = [&](const MountedDisk& disk) {
    const auto root = disk.root + QLatin1Char('/');
    return disk.isWritable && disk.device != device &&
           (root.startsWith(QLatin1String("/media/")) ||
            root.startsWith(QLatin1String("/run/media/")) ||
            root.startsWith(QLatin1String("/mnt/")));
  };
  const auto found = std::ranges::find_if(disks, isApart);
  return found == disks.end() ? QString() : found->root;
}

QString pathApart(const std::string& folder, const QString& what, const QString& extension) {
  std::vector<MountedDisk> disks;
  for (const auto& disk : QStorageInfo::mountedVolumes()) {
    const bool isKept = disk.isReady() && !disk.isReadOnly() && disk.fileSystemType() != "tmpfs";
    const bool isWritable = isKept && QFileInfo(disk.rootPath()).isWritable();
    disks.push_back({disk.rootPath(), disk.device(), isWritable});
  }
  const auto own = QStorageInfo(QString::fromStdString(folder)).device();
  const auto other = diskApartFrom(own, disks);
  const QDir place(other.isEmpty() ? QDir::homePath() : other);
  return unusedPath(place.filePath(nameToday(folder, what)), extension);
}

bool isOnDiskOf(const std::string& folder, const QString& path) {
  if (path.isEmpty()) return false;
  QFileInfo target(path);
  while (!target.exists() && !target.isRoot()) target.setFile(target.absolutePath());
  return QStorageInfo(target.absoluteFilePath()).device() ==
         QStorageInfo(QString::fromStdString(folder)).device();
}

BackupDialog::BackupDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Back up a study"),
          tr("Copies all of “%1” as it is at one moment, also while sessions are open, and "
             "verifies the copy. Keep it on another disk, as carefully as the study: it contains "
             "the participants' names.")
              .arg(QString::fromStdString(study.title)),
          tr("Back up"),
          parent),
      folder_(study.folder),
      target_(new PathField(PathField::Kind::NewFolder, tr("New folder"), {}, this)) {
  target_->setPath(pathApart(folder_, QStringLiteral("backup")));
  form().addRow(tr("To a new folder"), target_);
  sameDisk_ = addHint(tr("This is the disk of the study: if it fails, both are lost."));
  setRole(*sameDisk_, "warn");
  connect(target_, &PathField::pathChanged, this, &BackupDialog::updateChoices);
  updateChoices();
}

void BackupDialog::updateChoices() {
  const auto path = target_->path();
  form().setRowVisible(sameDisk_, isOnDiskOf(folder_, path));
  setDisabledReason(path.isEmpty() ? tr("Choose a new folder.") : QString());
  fit();
}

void BackupDialog::work() {
  Backup backup;
  const std::string target = target_->path().toStdString();
  const bool isDone = BackgroundTask::run(
      this, tr("Backing up"), MessageTopic::BackupNotSaved, [&](const Progress& progress) {
        backup = backUp(folder_, target, progress);
      });
  if (!isDone) return clear();
  const double megabytes = 1e-6 * static_cast<double>(backup.bytes);
  auto checks = notesOf(backup.verification);
  if (!backup.isNoted) checks.push_back({deskText(kCopyNotNoted), Mark::Warning});
  if (backup.verification.isSound()) {
    const QString path = target_->path();
    target_->setPath(QString());
    showWrittenFile(
        path,
        tr("Backup saved and verified: %1 (%2 MB)").arg(path).arg(megabytes, 0, 'f', 1),
        checks);
  } else {
    showOutcome(Outcome::Bad, tr("The study is damaged, and so is the copy."), checks);
  }
}

VerifyDialog::VerifyDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Verify a study"),
          tr("Reads all data of “%1” and checks that nothing was changed, lost or damaged.")
              .arg(QString::fromStdString(study.title)),
          tr("Verify"),
          parent),
      folder_(study.folder),
      restoredButton_(new QPushButton(tr("A backup was put back on purpose…"), this)) {
  restoredButton_->setObjectName(QStringLiteral("restored"));
  restoredButton_->setAutoDefault(false);
  form().addRow(QString(), restoredButton_);
  form().setRowVisible(restoredButton_, false);
  connect(restoredButton_, &QPushButton::clicked, this, &VerifyDialog::recordRestoredBackup);
}

void VerifyDialog::recordRestoredBackup() {
  const auto reason = askForText(this, MessageTopic::RestoredBackup);
  if (!reason) return;
  const bool isNoted = attempt(this, MessageTopic::BackupNotNoted, [&] {
    auto study = Study::open(folder_);
    recordRestoredCopy(study, reason->trimmed().toStdString());
  });
  if (isNoted) work();
}

void VerifyDialog::work() {
  Verification verification;
  std::size_t missing = 0;
  bool isOlderCopy = false;
  const bool isDone = BackgroundTask::run(
      this,
      tr("Verifying the study"),
      MessageTopic::StudyNotVerified,
      [&](const Progress& progress) {
        auto study = Study::open(folder_, storage::Database::Access::ReadOnly);
        verification = verify(study, progress);
        missing = headsMissingIn(study);
        if (missing == 0 || verification.isSound()) return;
        const auto asCopy = verify(study, progress, {.isOlderCopy = true});
        isOlderCopy = asCopy.isSound();
        if (isOlderCopy) verification = asCopy;
      });
  if (!isDone) return clear();
  form().setRowVisible(restoredButton_, missing > 0);
  runButton().setText(tr("Verify again"));
  const auto checks = notesOf(verification);
  if (isOlderCopy) {
    auto notes = checks;
    notes.insert(
        notes.begin(),
        {{tr("A backup of a study that went on is such a copy: keep it, and go on with the "
             "study.")},
         {tr("If this is the study itself, its latest events are missing. Restore the newest "
             "backup."),
          Mark::Warning}});
    showOutcome(
        Outcome::Warning,
        tr("This is an older copy of the study. What it has is undamaged."),
        notes);
  } else if (verification.isSound()) {
    const auto remarks = std::ranges::count(checks, Mark::None, &Note::mark);
    showOutcome(
        Outcome::Good,
        remarks == 0 ? tr("All data are unchanged.")
                     : tr("No change was found. Not everything can be proven: see “–” below."),
        checks);
  } else {
    showOutcome(
        Outcome::Bad,
        tr("Some data have changed. Keep the folder as it is, and restore a backup from "
           "before."),
        checks);
  }
}

ReportDialog::ReportDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Write the report"),
          tr("Tables, figures and forces, as a web page or PDF. The report names every condition: "
             "do not open it if you must stay blinded. The reason for unblinding goes into the "
             "audit trail."),
          tr("Write"),
          parent),
      folder_(study.folder),
      mode_(makeRunModeBox(study, this)),
      language_(new QComboBox(this)),
      wording_(new QComboBox(this)),
      paper_(new QComboBox(this)),
      quotes_(new QCheckBox(tr("With what participants wrote: may point to a person"), this)),
      target_(new PathField(
          PathField::Kind::NewFile, tr("New file"), tr("Reports (*.html *.pdf)"), this)),
      figures_(new QCheckBox(tr("Each figure as SVG, PDF and PNG"), this)),
      width_(new QSpinBox(this)),
      font_(new QDoubleSpinBox(this)),
      writtenFigures_(new WrittenFile(this)) {
  addLanguages(*language_, words::languages());
  chooseLanguage(*language_, deskLanguage());
  language_->setAccessibleName(tr("Language"));
  wording_->addItem(tr("APA: p = .021 [0.41, 2.42]"), static_cast<int>(Wording::Apa));
  wording_->addItem(tr("Vancouver: P = 0.021, 0.41 to 2.42"), static_cast<int>(Wording::Vancouver));
  paper_->setAccessibleName(tr("Pages of a PDF"));
  paper_->setObjectName(QStringLiteral("paper"));
  paper_->addItem(QStringLiteral("A4"), static_cast<int>(report::Paper::A4));
  paper_->addItem(QStringLiteral("Letter"), static_cast<int>(report::Paper::Letter));
  quotes_->setObjectName(QStringLiteral("quotes"));
  quotes_->setChecked(true);
  target_->setPath(unusedPathBeside(folder_, QStringLiteral("report"), QStringLiteral(".html")));
  form().addRow(tr("Sessions"), mode_);
  addReason(tr("Reason for unblinding"), [this] { updateChoices(); });
  auto* pages = new QWidget(this);
  auto* side = withoutMargins<QHBoxLayout>(pages);
  side->addWidget(language_, 3);
  side->addWidget(paper_, 2);
  form().addRow(tr("Language and paper"), pages);
  form().addRow(tr("Numbers in sentences"), wording_);
  form().addRow(tr("Quotes"), quotes_);
  form().addRow(tr("File (.html or .pdf)"), target_);
  addFigures();
  connect(mode_, &QComboBox::currentIndexChanged, this, &ReportDialog::updateChoices);
  connect(target_, &PathField::pathChanged, this, &ReportDialog::updateChoices);
  connect(figures_, &QCheckBox::toggled, this, &ReportDialog::updateChoices);
  updateChoices();
}

void ReportDialog::addFigures() {
  constexpr int kLeastWidth = 60;  // of figures [mm]
  constexpr int kMostWidth = 400;
  constexpr int kOneColumn = 85;
  constexpr double kSmallest = 5.0;  // of fonts [pt]
  constexpr double kLargest = 14.0;
  constexpr double kUsualInJournals = 8.0;
  figures_->setObjectName(QStringLiteral("figures"));
  width_->setObjectName(QStringLiteral("figure-width"));
  width_->setRange(kLeastWidth, kMostWidth);
  width_->setValue(kOneColumn);
  font_->setRange(kSmallest, kLargest);
  font_->setSingleStep(0.5);
  font_->setDecimals(1);
  font_->setValue(kUsualInJournals);
  form().addRow(tr("For a journal"), figures_);
  form().addRow(tr("Width of figures [mm]"), width_);
  form().addRow(tr("Font size in figures [pt]"), font_);
  form().addRow(tr("Figures"), writtenFigures_);
  form().setRowVisible(writtenFigures_, false);
}

void ReportDialog::updateChoices() {
  form().setRowVisible(width_, figures_->isChecked());
  form().setRowVisible(font_, figures_->isChecked());
  const bool isOfPeople = chosenMode(*mode_) != RunMode::Simulated;
  showReason(isOfPeople);
  fit();
  setDisabledReason(
      !hasSessions(*mode_)             ? noSessionsText()
      : isOfPeople && reason().empty() ? tr("Give a reason.")
      : target_->path().isEmpty()      ? tr("Choose a new file.")
                                       : QString());
}

void ReportDialog::work() {
  const ReportRequest request{
      .folder = folder_,
      .mode = chosenMode(*mode_),
      .language = language_->currentData().toString().toStdString(),
      .wording = static_cast<Wording>(wording_->currentData().toInt()),
      .paper = static_cast<report::Paper>(paper_->currentData().toInt()),
      .hasQuotes = quotes_->isChecked(),
      .out = target_->path().toStdString(),
      .figures = figures_->isChecked()
                     ? unusedPathBeside(folder_, QStringLiteral("figures")).toStdString()
                     : std::string(),
      .format = {.width = width_->value(), .font = font_->value()},
      .reason = reason()};
  bool isNoted = true;
  const bool isDone = BackgroundTask::run(
      this,
      tr("Writing the report"),
      MessageTopic::ReportNotWritten,
      [&](const Progress& progress) { isNoted = write(request, progress); });
  form().setRowVisible(writtenFigures_, isDone && !request.figures.empty());
  writtenFigures_->show(QString::fromStdString(request.figures));
  if (!isDone) return clear();
  const QString path = target_->path();
  rememberDocument(QString::fromStdString(folder_), path);
  const QString figures = QString::fromStdString(request.figures);
  if (!figures.isEmpty()) rememberDocument(QString::fromStdString(folder_), figures);
  showWrittenFile(
      path,
      figures.isEmpty() ? tr("Report saved: %1").arg(path)
                        : tr("Report saved: %1; figures: %2").arg(path, figures),
      isNoted ? std::vector<Note>() : std::vector<Note>{{deskText(kCopyNotNoted), Mark::Warning}});
  const auto extension = QLatin1Char('.') + QFileInfo(path).suffix();
  target_->setPath(unusedPathBeside(folder_, QStringLiteral("report"), extension));
}

}  // namespace study::gui
