#include "study/gui/desk/measurement_dialogs.h"

#include <algorithm>
#include <array>
#include <optional>

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QScreen>

#include "study/gui/desk/measurement_work.h"
#include "study/gui/widgets/background_task.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/model/user_error.h"
#include "study/session/import_recording.h"

namespace study::gui {
namespace {

constexpr int kMostSpheres = 2'000'000;
constexpr int kUsualSpheres = 201'532;  // as in the published model

/// Runs the work behind a progress dialog. Returns its result; std::nullopt if it failed or was
/// cancelled.
template <typename Work>
auto runWithProgress(QWidget* parent, const QString& title, const Work& work)
    -> std::optional<decltype(work(Progress()))> {
  decltype(work(Progress())) result;
  const bool isDone = BackgroundTask::run(
      parent, title, MessageTopic::DocumentNotMade, [&](const Progress& progress) {
        result = work(progress);
      });
  if (!isDone) return std::nullopt;
  return result;
}

/// The largest error of the minimum, average and maximum curve of a test, each a share of the force
/// there, or of 10 N if that is more.
std::array<double, 3> errorsOf(const haptics::reaming::TestSetFit& test) {
  return {
      test.force.minimum.error.floored,
      test.force.average.error.floored,
      test.force.maximum.error.floored};
}

QString newFile(const char* name, const char* extension) {
  return unusedPath(
      QDir(documentsFolder()).filePath(QString::fromUtf8(name)), QString::fromUtf8(extension));
}

/// Gives @p field a free name for the next file, where the last one has been @p written to its
/// path: "my-cut.json" → "my-cut-2.json".
void nameNext(PathField& field, const QString& written) {
  if (field.path() != written || written.isEmpty()) return;
  static const QRegularExpression kNumber(QStringLiteral("-\\d+$"));
  const QFileInfo file(field.path());
  const auto start = file.completeBaseName().remove(kNumber);
  field.setPath(unusedPath(file.dir().filePath(start), QLatin1Char('.') + file.suffix()));
}

}  // namespace

ImportCutDialog::ImportCutDialog(QWidget* parent)
    : WorkDialog(
          tr("Import a recording"),
          tr("Takes one cut from what the punch's recorder wrote, calibrated and filtered as "
             "published, or from any other table of time, travel and force. Put the new file "
             "beside a protocol and name it there as \"cut\"."),
          tr("Import"),
          parent),
      recording_(new PathField(
          PathField::Kind::ExistingFile, tr("Recording"), tr("Recordings (*)"), this)),
      columns_(new PathField(
          PathField::Kind::ExistingFile, tr("Columns file"), tr("Columns files (*.json)"), this)),
      columnsForm_(new ColumnsForm(this)),
      cut_(new QSpinBox(this)),
      slope_(new QDoubleSpinBox(this)),
      target_(new PathField(PathField::Kind::NewFile, tr("New file"), tr("Cuts (*.json)"), this)),
      recordingPlot_(new RecordingPlot(this)),
      cutPlot_(new CutPlot(this)) {
  constexpr double kMostSlope = 1e6;  // [N/travel unit]
  const double usualSlope = haptics::recordings::ImportOptions{}.maxSlope;
  slope_->setRange(0.01, kMostSlope);
  slope_->setValue(usualSlope);
  slope_->setSuffix(QLatin1Char(' ') + tr("N per travel unit"));
  slope_->setObjectName(QStringLiteral("slope"));
  cut_->setRange(0, 10'000);
  cut_->setSpecialValueText(tr("the most typical one"));
  recording_->setObjectName(QStringLiteral("recording"));
  columns_->setObjectName(QStringLiteral("columns"));
  target_->setObjectName(QStringLiteral("target"));
  target_->setPath(newFile("my-cut", ".json"));
  form().addRow(tr("Recording"), recording_);
  columns_->setHint(tr("optional"));
  form().addRow(tr("Columns file"), columns_);
  form().addRow(columnsForm_);
  columnsForm_->setVisible(false);
  form().addRow(tr("Which cut"), cut_);
  form().addRow(tr("Largest slope"), slope_);
  form().addRow(quietLabel(
      tr("Steeper parts of the cut are flattened to it. %1 is the largest stiffness in the cuts of "
         "the punch paper, at which its device stays stable.")
          .arg(usualSlope),
      this));
  form().addRow(tr("To a new file"), target_);
  form().addRow(cutPlot_->summary());
  auto* pictures = new QBoxLayout(QBoxLayout::LeftToRight);
  constexpr int kRecordingStretch = 6;  // it has two curves
  constexpr int kCutStretch = 5;
  pictures->addWidget(recordingPlot_, kRecordingStretch);
  pictures->addWidget(cutPlot_, kCutStretch);
  addBeside(pictures);
  const auto readAgain = [this] {
    columnsForm_->setVisible(false);
    showRecording();
  };
  connect(recording_, &PathField::pathChanged, this, readAgain);
  connect(columns_, &PathField::pathChanged, this, readAgain);
  connect(columnsForm_, &ColumnsForm::changed, this, &ImportCutDialog::showRecording);
  connect(cut_, &QSpinBox::valueChanged, this, &ImportCutDialog::preview);
  connect(slope_, &QDoubleSpinBox::valueChanged, this, &ImportCutDialog::preview);
  connect(target_, &PathField::pathChanged, this, &ImportCutDialog::updateButton);
  showRecording();
}

std::optional<haptics::recordings::RecordingColumns> ImportCutDialog::columns() const {
  if (!columns_->path().isEmpty()) return columnsIn(columns_->path().toStdString());
  return columnsForm_->isVisibleTo(this) ? std::optional(columnsForm_->columns()) : std::nullopt;
}

bool ImportCutDialog::lacksRate() const {
  const bool isAsked = columns_->path().isEmpty() && columnsForm_->isVisibleTo(this);
  return isAsked && columnsForm_->lacksRate();
}

std::optional<RecordingPreview> ImportCutDialog::readPreview() {
  const auto file = recording_->path().toStdString();
  if (lacksRate()) {
    showOutcome(Outcome::Warning, tr("This table has no time: how many rows has a second?"));
    return std::nullopt;
  }
  try {
    return previewOf(file, columns());
  } catch (const std::exception& error) {
    const bool mayAsk = columns_->path().isEmpty() && columnsForm_->isHidden();
    if (mayAsk && columnsForm_->offerColumnsOf(file)) {
      columnsForm_->setVisible(true);
      return readPreview();
    }
    showOutcome(
        Outcome::Bad, tr("This recording cannot be read"), {{QString::fromUtf8(error.what())}});
  }
  return std::nullopt;
}

void ImportCutDialog::showRecording() {
  clear();
  const auto isFile = [](const QString& path) { return QFileInfo(path).isFile(); };
  const QString columns = columns_->path();
  const bool isThere = isFile(recording_->path()) && (columns.isEmpty() || isFile(columns));
  recordingPlot_->show(isThere ? readPreview() : std::nullopt);
  constexpr int kMostCuts = 10'000;
  cut_->setRange(0, recordingPlot_->cuts() > 0 ? recordingPlot_->cuts() : kMostCuts);
  preview();
}

haptics::recordings::ImportOptions ImportCutDialog::options() const {
  haptics::recordings::ImportOptions options{.maxSlope = slope_->value()};
  if (cut_->value() > 0) options.closures = {static_cast<std::size_t>(cut_->value())};
  return options;
}

void ImportCutDialog::preview() {
  const auto& shown = recordingPlot_->preview();
  isImportPossible_ = shown.has_value();
  int taken = cut_->value();
  if (shown) {
    clear();                                // what was said about another cut
    constexpr int kRoomForPictures = 1320;  // [px]
    resize(
        std::max(width(), std::min(kRoomForPictures, screen()->availableSize().width())), height());
    try {
      const auto imported = importRecording(shown->recording, options());
      cutPlot_->show(shown->trace, imported);
      const auto& closures = imported.report.closures;
      if (!closures.empty()) taken = static_cast<int>(closures.front());
      if (cut_->value() == 0) cut_->setSpecialValueText(tr("the most typical: %1").arg(taken));
    } catch (const UserError& error) {
      isImportPossible_ = false;
      showOutcome(
          Outcome::Warning,
          tr("No cut can be taken from this recording yet"),
          {{QString::fromUtf8(error.what())}});
    }
  }
  cutPlot_->setShown(isImportPossible_);
  recordingPlot_->choose(taken);
  updateButton();
  fit();
}

void ImportCutDialog::updateButton() {
  setDisabledReason(
      recording_->path().isEmpty() ? tr("Choose a recording.")
      : lacksRate()                ? tr("Give the rows per second.")
      : !isImportPossible_         ? tr("No cut can be taken from this recording.")
      : target_->path().isEmpty()  ? tr("Choose a new file.")
                                   : QString());
}

void ImportCutDialog::work() {
  nameNext(*target_, written_);
  const auto recording = recording_->path().toStdString();
  const auto target = target_->path().toStdString();
  // Widgets are read here, and not in the thread of the work.
  const auto file = columns_->path().toStdString();
  const auto entered = file.empty() ? columns() : std::nullopt;
  const auto how = options();
  haptics::recordings::ImportReport report;
  const bool isDone = BackgroundTask::run(
      this, tr("Importing"), MessageTopic::DocumentNotMade, [&](const Progress& progress) {
        const auto columns = file.empty() ? entered : columnsIn(file);
        report = importCutTo(recording, columns, how, target, progress);
      });
  if (!isDone) return clear();
  std::vector<Note> more{{tr("Why this cut: %1").arg(deskText(report.reason))}};
  for (const auto& change : report.changes) more.push_back({capitalised(deskText(change))});
  const bool isAltered = report.isAltered();
  showWrittenFile(
      target_->path(),
      isAltered ? tr("Cut saved, but it is not what was recorded: %1").arg(peakInWords(report))
                : tr("Cut saved: %1").arg(target_->path()),
      more,
      isAltered ? Outcome::Warning : Outcome::Good);
  written_ = target_->path();
}

FitMaterialDialog::FitMaterialDialog(QWidget* parent)
    : WorkDialog(
          tr("Fit a material"),
          tr("Makes bone that can be felt from a folder of measured reaming series. The name of "
             "each file says of which test it is: static, dynamic-1 or dynamic-2, as in "
             "pig03-static.csv."),
          tr("Fit"),
          parent),
      series_(new PathField(PathField::Kind::ExistingFolder, tr("Folder of series"), {}, this)),
      title_(new QLineEdit(tr("A reaming material"), this)),
      target_(
          new PathField(PathField::Kind::NewFile, tr("New file"), tr("Materials (*.json)"), this)),
      result_(new ResultView(this)) {
  series_->setObjectName(QStringLiteral("series"));
  target_->setObjectName(QStringLiteral("target"));
  target_->setPath(newFile("my-material", ".json"));
  form().addRow(tr("Folder of series"), series_);
  form().addRow(tr("Title"), title_);
  form().addRow(tr("To a new file"), target_);
  const auto updateButton = [this] {
    setDisabledReason(
        series_->path().isEmpty()            ? tr("Choose the folder of series.")
        : title_->text().trimmed().isEmpty() ? tr("Give a title.")
        : target_->path().isEmpty()          ? tr("Choose a new file.")
                                             : QString());
  };
  addResult(result_);
  result_->hide();
  connect(series_, &PathField::pathChanged, this, updateButton);
  connect(title_, &QLineEdit::textChanged, this, updateButton);
  connect(target_, &PathField::pathChanged, this, updateButton);
  updateButton();
  fit();
}

void FitMaterialDialog::work() {
  nameNext(*target_, written_);
  const auto series = series_->path().toStdString();
  const auto title = title_->text().toStdString();
  const auto target = target_->path().toStdString();
  const auto fitted =
      runWithProgress(this, tr("Fitting the material"), [&](const Progress& progress) {
        return fitMaterialTo(series, title, target, progress);
      });
  result_->setVisible(fitted.has_value());
  if (!fitted) return clear();
  showResult(fitted->fit);
  std::vector<Note> notes;
  if (fitted->isSynthetic) {
    notes.push_back({tr("Synthetic: nobody measured these series."), Mark::Warning});
  }
  constexpr double kPoor = 0.1;
  for (const auto& test : fitted->fit.sets) {
    const auto& [minimum, average, maximum] = errorsOf(test);
    if (std::max({minimum, average, maximum}) <= kPoor) continue;
    notes.push_back(
        {tr("%1: a curve misses its series by more than 10 %.").arg(asText(nameOf(test.set))),
         Mark::Warning});
  }
  for (const auto& one : fitted->fit.series) {
    if (!one.exclusion.isExcluded()) continue;
    notes.push_back(
        {tr("Left out: %1").arg(asText(one.name + ": " + one.exclusion.words)), Mark::Warning});
  }
  showWrittenFile(target_->path(), tr("Material saved: %1").arg(target_->path()), notes);
  written_ = target_->path();
  runButton().setText(tr("Fit again"));
}

void FitMaterialDialog::showResult(const haptics::reaming::MaterialFit& fit) {
  const auto words = [](const QString& text) { return Heading::ofWords(text.toStdString()); };
  const auto number = [](const QString& text) { return Heading{text.toStdString()}; };
  const auto cell = [](double value, int decimals) {
    return QString::number(value, 'f', decimals).toStdString();
  };
  DataTable table{
      .name = "material-errors",
      .description = tr("Largest error of the fit [%]").toStdString(),
      .columns = {
          words(tr("Test")),
          number(tr("Series")),
          number(tr("Depth [mm]")),
          number(tr("Minimum")),
          number(tr("Mean")),
          number(tr("Maximum"))}};
  for (const auto& test : fit.sets) {
    const auto& [minimum, average, maximum] = errorsOf(test);
    table.rows.push_back(
        {std::string(nameOf(test.set)),
         std::to_string(test.used),
         cell(1000.0 * test.scale, 2),
         cell(100.0 * minimum, 1),
         cell(100.0 * average, 1),
         cell(100.0 * maximum, 1)});
  }
  const auto meaning =
      tr("A fit has a curve each for the minimum, the mean and the maximum force of its series. "
         "Its error is in percent of the measured force; below 10 N, in percent of 10 N.");
  result_->show({.finding = {}, .more = meaning.toStdString()}, {table});
}

BuildBoneDialog::BuildBoneDialog(QWidget* parent)
    : WorkDialog(
          tr("Build a bone of spheres"),
          tr("Fills the program's own acetabulum, a cup-shaped socket, with spheres that a reamer "
             "takes "
             "away."),
          tr("Build"),
          parent),
      spheres_(new QSpinBox(this)),
      seed_(new QSpinBox(this)),
      target_(new PathField(
          PathField::Kind::NewFile, tr("New file"), tr("Packings (*.packing)"), this)) {
  spheres_->setRange(100, kMostSpheres);
  spheres_->setValue(kUsualSpheres);
  spheres_->setObjectName(QStringLiteral("spheres"));
  seed_->setRange(1, 1'000'000);
  target_->setObjectName(QStringLiteral("target"));
  target_->setPath(newFile("my-bone", ".packing"));
  form().addRow(tr("Spheres"), spheres_);
  addHint(tr("%1 are those of the published model. More of them are smaller, and take longer.")
              .arg(kUsualSpheres));
  form().addRow(tr("Seed"), seed_);
  addHint(tr("The same number builds the same bone."));
  form().addRow(tr("To a new file"), target_);
  connect(target_, &PathField::pathChanged, this, [this](const QString& path) {
    setDisabledReason(path.isEmpty() ? tr("Choose a new file.") : QString());
  });
  fit();
}

void BuildBoneDialog::work() {
  nameNext(*target_, written_);
  const auto spheres = static_cast<std::size_t>(spheres_->value());
  const auto seed = static_cast<std::uint64_t>(seed_->value());
  const auto target = target_->path().toStdString();
  const auto bone = runWithProgress(this, tr("Placing spheres"), [&](const Progress& progress) {
    return buildBoneTo(spheres, seed, target, progress);
  });
  if (!bone) return clear();
  const auto& packing = bone->packing;
  const auto number = [](double value, int decimals) {
    return QString::number(value, 'f', decimals);
  };
  showWrittenFile(
      target_->path(),
      tr("Bone saved: %1").arg(target_->path()),
      {{tr("%1 spheres of %2 to %3 mm cover %4 % of %5 cm³.")
            .arg(
                QString::number(packing.spheres.size()),
                number(1e3 * packing.spheres.back().radius, 3),
                number(1e3 * packing.spheres.front().radius, 3),
                number(100.0 * packing.coverage(), 1),
                number(1e6 * packing.volume, 1))},
       {tr("Synthetic: nobody measured this bone."), Mark::Warning},
       {tr("It has no densities yet: the help says how to give it those of a material (On the "
           "command line).")}});
  written_ = target_->path();
}

}  // namespace study::gui
