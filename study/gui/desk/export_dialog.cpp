#include "study/gui/desk/export_dialog.h"

#include <algorithm>

#include "study/export/condition_codes.h"
#include "study/export/named_people.h"
#include "study/export/public_people.h"
#include "study/export/public_tables.h"
#include "study/gui/desk/recent_studies.h"
#include "study/gui/desk/study_dialogs.h"
#include "study/gui/widgets/background_task.h"
#include "study/gui/widgets/desk_language.h"
#include "study/session/unblinding.h"

namespace study::gui {
namespace {

enum class Audience { Blinded, Unblinded, Public };

constexpr int kLargestGroupLimit = 1000;

Audience audienceOf(const QComboBox& choice) {
  return static_cast<Audience>(choice.currentData().toInt());
}

/// How many people a reader could recognise.
std::vector<Note> notesOf(const ClassSizes& classes) {
  if (classes.people == 0) return {};
  if (classes.peopleInSmallClasses == 0) {
    return {{ExportDialog::tr("Nobody is alone with their cohort and background."), Mark::Good}};
  }
  return {
      {ExportDialog::tr("People who can be recognised by their cohort and background: %1 of %2.")
           .arg(classes.peopleInSmallClasses)
           .arg(classes.people),
       Mark::Warning,
       {ExportDialog::tr("A reader who knows these finds the other answers. To publish data, make "
                         "an export for the public instead.")}}};
}

/// Whether any version of the protocol asks people for a number, such as their age.
bool asksForNumbers(Study& study) {
  for (const auto id : study.protocols().all()) {
    const auto questions = backgroundQuestionsOf(study.protocol(id));
    const auto isNumber = [](const BackgroundQuestion& question) {
      return publicFormOf(*question.item) == PublicForm::Bands;
    };
    if (std::ranges::any_of(questions, isNumber)) return true;
  }
  return false;
}

/// Whether names of participants are in what is exported.
Note noteOf(const NameSearchResult& named, bool hasTexts) {
  QStringList advice;
  if (hasTexts) advice << ExportDialog::tr("Read free texts before you give them away.");
  if (named.areLocked) {
    return {
        ExportDialog::tr(
            "Names are behind a passphrase that was not given: none was searched for."),
        Mark::Warning,
        advice};
  }
  if (named.names == 0) {
    return {
        ExportDialog::tr("No names are kept, so none was searched for in these data."),
        Mark::None,
        advice};
  }
  QStringList where;
  for (const auto& [table, count] : named.cells) {
    where << QStringLiteral("%1: %2").arg(asText(table)).arg(count);
  }
  if (!where.isEmpty()) {
    return {
        ExportDialog::tr("This folder names people: do not give it away as it is."),
        Mark::Bad,
        {ExportDialog::tr("Cells with a word of a name that the study keeps apart: %1")
             .arg(where.join(QStringLiteral(", ")))}};
  }
  return {
      ExportDialog::tr("No participant's name was found in these data."),
      Mark::Good,
      QStringList(ExportDialog::tr("Names of other people were not searched for.")) + advice};
}

}  // namespace

ExportDialog::ExportDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Export data"),
          tr("Tidy tables, one row per answer, with a dictionary, in a new folder."),
          tr("Export"),
          parent),
      folder_(study.folder),
      format_(new QComboBox(this)),
      mode_(makeRunModeBox(study, this)),
      audience_(new QComboBox(this)),
      smallestGroup_(new QSpinBox(this)),
      exactDates_(new QCheckBox(tr("Exact dates and times"), this)),
      writtenTexts_(new QCheckBox(tr("Texts that participants and operators wrote"), this)),
      traces_(new QCheckBox(tr("Recordings: what was felt, sample by sample"), this)),
      target_(new PathField(PathField::Kind::NewFolder, tr("New folder"), {}, this)),
      earlierExport_(new PathField(
          PathField::Kind::ExistingFolder, tr("Folder of an earlier export"), {}, this)) {
  const auto add = [](QComboBox* box, const QString& words, auto value) {
    box->addItem(words, static_cast<int>(value));
  };
  add(format_, tr("Tables (CSV)"), ExportFormat::Csv);
  add(format_, tr("One document (JSON)"), ExportFormat::Json);
  add(format_, tr("Psych-DS"), ExportFormat::PsychDs);
  add(format_, tr("BIDS"), ExportFormat::Bids);
  add(format_, tr("Tables with a script for R"), ExportFormat::R);
  add(format_, tr("Tables with a script for Python"), ExportFormat::Python);
  add(audience_, tr("Analysts, blinded: codes instead of conditions"), Audience::Blinded);
  add(audience_, tr("Analysts, unblinded: is noted in the audit trail"), Audience::Unblinded);
  add(audience_, tr("The public: groups in which nobody stands out"), Audience::Public);
  audience_->setObjectName(QStringLiteral("audience"));
  smallestGroup_->setObjectName(QStringLiteral("smallest-class"));
  smallestGroup_->setRange(static_cast<int>(kSmallestPublicClassSize), kLargestGroupLimit);
  exactDates_->setObjectName(QStringLiteral("exact"));
  writtenTexts_->setObjectName(QStringLiteral("texts"));
  target_->setPath(unusedPathBeside(folder_, QStringLiteral("data")));
  earlierExport_->startIn(folderBeside(folder_));
  earlierExport_->setHint(tr("an earlier export (optional)"));
  form().addRow(tr("For whom"), audience_);
  form().addRow(tr("Smallest group of people"), smallestGroup_);
  addReason(tr("Reason for unblinding"), [this] { updateButton(); });
  form().addRow(tr("Sessions"), mode_);
  form().addRow(tr("Format"), format_);
  form().addRow(tr("Also export"), exactDates_);
  form().addRow(QString(), writtenTexts_);
  form().addRow(QString(), traces_);
  form().addRow(tr("To a new folder"), target_);
  form().addRow(tr("Use the codes of"), earlierExport_);
  connect(audience_, &QComboBox::currentIndexChanged, this, &ExportDialog::updateChoices);
  connect(mode_, &QComboBox::currentIndexChanged, this, &ExportDialog::updateChoices);
  connect(smallestGroup_, &QSpinBox::valueChanged, this, &ExportDialog::updateChoices);
  connect(exactDates_, &QCheckBox::toggled, this, &ExportDialog::updateChoices);
  connect(writtenTexts_, &QCheckBox::toggled, this, &ExportDialog::updateChoices);
  connect(target_, &PathField::pathChanged, this, &ExportDialog::updateButton);
  updateChoices();
}

ExportOptions ExportDialog::options() const {
  const auto audience = audienceOf(*audience_);
  ExportOptions options{
      .format = static_cast<ExportFormat>(format_->currentData().toInt()),
      .runMode = chosenMode(*mode_),
      .isBlinded = audience != Audience::Unblinded,
      .hasTraces = audience == Audience::Unblinded && traces_->isChecked(),
      .isExact = audience != Audience::Public && exactDates_->isChecked(),
      .hasTexts = audience != Audience::Public && writtenTexts_->isChecked()};
  if (audience == Audience::Public) {
    options.publicClassSize = static_cast<std::size_t>(smallestGroup_->value());
  }
  return options;
}

void ExportDialog::updateChoices() {
  const auto audience = audienceOf(*audience_);
  form().setRowVisible(smallestGroup_, audience == Audience::Public);
  showReason(audience == Audience::Unblinded);
  form().setRowVisible(exactDates_, audience != Audience::Public);
  form().setRowVisible(writtenTexts_, audience != Audience::Public);
  form().setRowVisible(traces_, audience == Audience::Unblinded);
  const bool hasCodes = audience != Audience::Public && chosenMode(*mode_) != RunMode::Simulated;
  form().setRowVisible(earlierExport_, hasCodes);
  clear();
  showIdentifiability();
  updateButton();
}

void ExportDialog::updateButton() {
  const bool needsReason = audienceOf(*audience_) == Audience::Unblinded;
  setDisabledReason(
      !hasSessions(*mode_)              ? noSessionsText()
      : !isExportPossible_              ? tr("These data cannot be exported.")
      : needsReason && reason().empty() ? tr("Give a reason.")
      : target_->path().isEmpty()       ? tr("Choose a new folder.")
                                        : QString());
}

void ExportDialog::showIdentifiability() {
  isExportPossible_ = true;
  try {
    auto study = Study::open(folder_, storage::Database::Access::ReadOnly);
    exactDates_->setText(
        asksForNumbers(study) ? tr("Exact dates and times, and numbers such as ages")
                              : tr("Exact dates and times"));
    const auto how = options();
    if (how.publicClassSize) {
      showDetails({{QString::fromStdString(study::describe(publicRelease(study, how))).trimmed()}});
    } else if (how.runMode == RunMode::Simulated) {
      showDetails({{tr("Nothing in this folder names a person."), Mark::Good}});
    } else {
      auto notes = notesOf(classSizesAsReleased(study, how));
      if (how.isExact) {
        notes.push_back(
            {tr("Exact dates point to people more than days and bands do: export them only if "
                "participants were told so."),
             Mark::Warning});
      }
      notes.push_back(noteOf(searchForNames(study, exportTables(study, how)), how.hasTexts));
      showDetails(notes);
    }
  } catch (const std::exception& error) {
    showOutcome(Outcome::Bad, QString::fromUtf8(error.what()));
    isExportPossible_ = false;
  }
}

void ExportDialog::work() {
  auto how = options();
  const std::string target = target_->path().toStdString();
  const std::string why = reason();
  WrittenExport written;
  std::string what;
  const std::string earlier =
      form().isRowVisible(earlierExport_) ? earlierExport_->path().toStdString() : std::string();
  const auto write = [&](const Progress& progress) {
    if (!earlier.empty()) how.codes = codeSetOf(earlier);
    auto study = openForExport(folder_, how);
    how.progress = progress;
    written = exportStudy(study, target, how, why);
    what = how.publicClassSize ? "for the public" : blindingInWords(study, how);
  };
  const bool isDone =
      BackgroundTask::run(this, tr("Exporting"), MessageTopic::DataNotExported, write);
  if (!isDone) return;
  const QString path = target_->path();
  const auto sessions = written.sessions;
  QString line = tr("Data saved: %1 (%2, %3)")
                     .arg(
                         path,
                         QString::fromStdString(
                             translated(sessions == 1 ? "{} session" : "{} sessions", sessions)),
                         deskText(what));
  if (!written.isNoted) line += QLatin1Char('\n') + deskText(kCopyNotNoted);
  if (sessions == 0) return showOutcome(Outcome::Warning, line);
  rememberDocument(QString::fromStdString(folder_), path);
  target_->setPath(unusedPathBeside(folder_, QStringLiteral("data")));
  showWrittenFile(path, line);
}

}  // namespace study::gui
