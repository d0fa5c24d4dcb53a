#include "study/gui/desk/measurement_dialogs.h"

#include <functional>
#include <optional>

#include <QDir>
#include <QFileInfo>

#include "study/gui/desk/measurement_work.h"
#include "study/gui/desk/recording_picture.h"
#include "study/gui/widgets/background_task.h"

namespace study::gui {
namespace {

constexpr int kMostSpheres = 2'000'000;
constexpr int kUsualSpheres = 201'532;  // as in the published model

/// Runs the work behind a progress dialog.
/// @return the description of its result; std::nullopt if it failed or was cancelled.
std::optional<QString> runWithProgress(
    QWidget* parent,
    const QString& title,
    const std::function<std::string(const Progress&)>& work) {
  std::string said;
  const bool isDone =
      BackgroundTask::run(parent, title, [&](const Progress& progress) { said = work(progress); });
  return isDone ? std::optional(QString::fromStdString(said)) : std::nullopt;
}

QString atHome(const char* name) {
  return QDir::home().filePath(QString::fromUtf8(name));
}

}  // namespace

ImportCutDialog::ImportCutDialog(QWidget* parent)
    : WorkDialog(
          tr("Import a recording"),
          tr("Takes one cut from what the punch's recorder wrote (five columns), calibrated and "
             "filtered as published, or from a table that a columns file describes. Put it beside "
             "a "
             "protocol and name it there as \"cut\"."),
          tr("Import"),
          parent),
      recording_(new PathField(
          PathField::Kind::ExistingFile, tr("Recording"), tr("Recordings (*)"), this)),
      columns_(new PathField(
          PathField::Kind::ExistingFile, tr("Columns file"), tr("Columns files (*.json)"), this)),
      cut_(new QSpinBox(this)),
      target_(new PathField(PathField::Kind::NewFile, tr("New file"), tr("Cuts (*.json)"), this)),
      picture_(new RecordingPicture(this)) {
  cut_->setRange(0, 10'000);
  cut_->setSpecialValueText(tr("the most typical one"));
  cut_->setAccessibleName(tr("Which cut"));
  recording_->setObjectName(QStringLiteral("recording"));
  columns_->setObjectName(QStringLiteral("columns"));
  target_->setObjectName(QStringLiteral("target"));
  target_->setPath(atHome("my-cut.json"));
  form().addRow(tr("Recording"), recording_);
  form().addRow(tr("Columns file (if it has other columns)"), columns_);
  form().addRow(tr("Which cut"), cut_);
  form().addRow(tr("To a new file"), target_);
  form().addRow(picture_);
  connect(recording_, &PathField::pathChanged, this, &ImportCutDialog::look);
  connect(columns_, &PathField::pathChanged, this, &ImportCutDialog::look);
  connect(cut_, &QSpinBox::valueChanged, picture_, &RecordingPicture::choose);
  look();
}

void ImportCutDialog::look() {
  std::optional<RecordingLook> read;
  clear();
  const QString columns = columns_->path();
  if (QFileInfo(recording_->path()).isFile() &&
      (columns.isEmpty() || QFileInfo(columns).isFile())) {
    try {
      read = lookAt(recording_->path().toStdString(), columns.toStdString());
    } catch (const std::exception& error) {
      showOutcome(
          Outcome::Bad, tr("This recording cannot be read"), QString::fromUtf8(error.what()));
    }
  }
  picture_->show(std::move(read));
  constexpr int kMostCuts = 10'000;
  cut_->setRange(0, picture_->cuts() > 0 ? picture_->cuts() : kMostCuts);
  fit();
}

void ImportCutDialog::work() {
  const auto recording = recording_->path().toStdString();
  const auto columns = columns_->path().toStdString();
  const auto target = target_->path().toStdString();
  const auto cut =
      cut_->value() == 0 ? std::nullopt : std::optional(static_cast<std::size_t>(cut_->value()));
  const auto said = runWithProgress(this, tr("Importing"), [&](const Progress& progress) {
    return importCutTo(recording, columns, cut, target, progress);
  });
  if (!said) return clear();
  showWritten(target_->path(), tr("Cut saved: %1").arg(target_->path()), *said);
}

FitMaterialDialog::FitMaterialDialog(QWidget* parent)
    : WorkDialog(
          tr("Fit a material"),
          tr("Makes bone that can be felt from a folder of measured reaming series. The name of "
             "each file says of which test it is: static, dynamic-1 or dynamic-2. Other choices: "
             "'palpate material fit'."),
          tr("Fit"),
          parent),
      series_(new PathField(PathField::Kind::ExistingFolder, tr("Folder of series"), {}, this)),
      title_(new QLineEdit(tr("A reaming material"), this)),
      target_(
          new PathField(PathField::Kind::NewFile, tr("New file"), tr("Materials (*.json)"), this)) {
  title_->setAccessibleName(tr("Title"));
  series_->setObjectName(QStringLiteral("series"));
  target_->setObjectName(QStringLiteral("target"));
  target_->setPath(atHome("my-material.json"));
  form().addRow(tr("Folder of series"), series_);
  form().addRow(tr("Title"), title_);
  form().addRow(tr("To a new file"), target_);
  fit();
}

void FitMaterialDialog::work() {
  const auto series = series_->path().toStdString();
  const auto title = title_->text().toStdString();
  const auto target = target_->path().toStdString();
  const auto said =
      runWithProgress(this, tr("Fitting the material"), [&](const Progress& progress) {
        return fitMaterialTo(series, title, target, progress);
      });
  if (!said) return clear();
  showWritten(target_->path(), tr("Material saved: %1").arg(target_->path()), *said);
}

BuildBoneDialog::BuildBoneDialog(QWidget* parent)
    : WorkDialog(
          tr("Build a bone of spheres"),
          tr("Fills the program's own cup with spheres that a reamer takes away. For a mesh of "
             "your "
             "own: 'palpate packing build MESH'."),
          tr("Build"),
          parent),
      spheres_(new QSpinBox(this)),
      seed_(new QSpinBox(this)),
      target_(new PathField(
          PathField::Kind::NewFile, tr("New file"), tr("Packings (*.packing)"), this)) {
  spheres_->setRange(100, kMostSpheres);
  spheres_->setValue(kUsualSpheres);
  spheres_->setAccessibleName(tr("Spheres"));
  spheres_->setObjectName(QStringLiteral("spheres"));
  seed_->setRange(1, 1'000'000);
  seed_->setAccessibleName(tr("Seed"));
  target_->setObjectName(QStringLiteral("target"));
  target_->setPath(atHome("my-bone.packing"));
  form().addRow(tr("Spheres"), spheres_);
  form().addRow(tr("Seed"), seed_);
  form().addRow(tr("To a new file"), target_);
  fit();
}

void BuildBoneDialog::work() {
  const auto spheres = static_cast<std::size_t>(spheres_->value());
  const auto seed = static_cast<std::uint64_t>(seed_->value());
  const auto target = target_->path().toStdString();
  const auto said = runWithProgress(this, tr("Placing spheres"), [&](const Progress& progress) {
    return buildBoneTo(spheres, seed, target, progress);
  });
  if (!said) return clear();
  showWritten(target_->path(), tr("Bone saved: %1").arg(target_->path()), *said);
}

}  // namespace study::gui
