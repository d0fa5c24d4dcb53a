#pragma once

#include <string>

#include <QComboBox>
#include <QLineEdit>
#include <QString>

#include "study/gui/desk/study_summary.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"

namespace study::gui {

/// Saves the key of a study to a file or loads it from one, as `palpate study key` does; encrypts
/// the participants' names with a passphrase, as `palpate study names --set-passphrase` does.
class KeyDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit KeyDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  /// What the operator has chosen to do; work() does it.
  enum class KeyTask { Save, Take, SealNames };

  KeyTask chosenTask() const;
  void updateChoices();
  void showState();
  void saveKey();
  void sealNames();

  std::string folder_;
  QComboBox* task_;
  PathField* target_;
  QLabel* sameDisk_ = nullptr;  ///< warns that the target is on the disk of the study
  PathField* source_;
  QLineEdit* passphrase_;
  QLineEdit* passphraseAgain_;
};

}  // namespace study::gui
