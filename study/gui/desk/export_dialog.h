#pragma once

#include <string>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QSpinBox>

#include "study/export/export.h"
#include "study/gui/desk/study_summary.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"

namespace study::gui {

/// Data for others, blinded unless somebody gives a reason. For strangers: who could be found among
/// whom stands in the window before anything is written.
class ExportDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit ExportDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  ExportOptions options() const;
  void updateChoices();
  void lookAtClasses();

  std::string folder_;
  QComboBox* format_;
  QComboBox* mode_;
  QComboBox* audience_;
  QSpinBox* smallest_;
  QLineEdit* reason_;
  QCheckBox* traces_;
  PathField* target_;
};

}  // namespace study::gui
