#pragma once

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSpinBox>

#include "haptics/reaming/material/material_fit.h"
#include "study/gui/desk/columns_form.h"
#include "study/gui/desk/recording_plots.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"

namespace study::gui {

/// Imports a cut for use in a protocol: from a recording of the punch, or from a table whose
/// columns are chosen in a form or described in a columns file.
class ImportCutDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit ImportCutDialog(QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  /// Shows the chosen recording before it is imported; asks for its columns if the punch's recorder
  /// did not write it.
  void showRecording();
  std::optional<RecordingPreview> readPreview();
  bool lacksRate() const;
  std::optional<haptics::recordings::RecordingColumns> columns() const;
  /// Shows the cut that an import would make of the chosen recording.
  void preview();
  haptics::recordings::ImportOptions options() const;
  void updateButton();

  PathField* recording_;
  PathField* columns_;
  ColumnsForm* columnsForm_;
  QSpinBox* cut_;
  QDoubleSpinBox* slope_;
  PathField* target_;
  QString written_;  ///< path of the last file that was saved; empty before
  RecordingPlot* recordingPlot_;
  CutPlot* cutPlot_;
  bool isImportPossible_ = false;  ///< a cut can be taken
};

/// Fits a reaming material to a folder of measured series.
class FitMaterialDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit FitMaterialDialog(QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  void showResult(const haptics::reaming::MaterialFit& fit);

  PathField* series_;
  QLineEdit* title_;
  PathField* target_;
  QString written_;  ///< path of the last file that was saved; empty before
  ResultView* result_;
};

/// Fills the built-in cup with spheres.
class BuildBoneDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit BuildBoneDialog(QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  QSpinBox* spheres_;
  QSpinBox* seed_;
  PathField* target_;
  QString written_;  ///< path of the last file that was saved; empty before
};

}  // namespace study::gui
