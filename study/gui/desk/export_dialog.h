#pragma once

#include <string>

#include <QCheckBox>
#include <QComboBox>
#include <QSpinBox>

#include "study/export/export.h"
#include "study/gui/desk/study_summary.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"

namespace study::gui {

/// Exports a study's data, blinded unless a reason for unblinding is given. Before an export for
/// the public, the dialog shows how many participants could be identified.
class ExportDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit ExportDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  ExportOptions options() const;
  void updateChoices();
  void updateButton();
  /// Shows how many participants the folder would make identifiable, before it is written.
  void showIdentifiability();

  std::string folder_;
  bool isExportPossible_ = true;  ///< whether what is chosen can be exported
  QComboBox* format_;
  QComboBox* mode_;
  QComboBox* audience_;
  QSpinBox* smallestGroup_;
  QCheckBox* exactDates_;
  QCheckBox* writtenTexts_;
  QCheckBox* traces_;
  PathField* target_;
  PathField* earlierExport_;  ///< an earlier export whose codes the new one reuses
};

}  // namespace study::gui
