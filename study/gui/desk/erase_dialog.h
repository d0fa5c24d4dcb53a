#pragma once

#include <string>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>

#include "study/gui/desk/study_summary.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"
#include "study/report/erasure_certificate.h"

namespace study::gui {

/// Erases a participant, as `palpate study erase` does. The code has to be typed, so that a mere
/// click cannot erase a participant.
class EraseDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit EraseDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  void fillIn();
  void updateButton();

  std::string folder_;
  QComboBox* participant_;
  QLabel* sessions_ = nullptr;  ///< cohort, date and state of each session of the participant
  QComboBox* level_;
  QLineEdit* code_;
  PathField* copy_;
  PathField* certificate_;
  QComboBox* language_;  ///< of the certificate
  QCheckBox* reseal_;
};

}  // namespace study::gui
