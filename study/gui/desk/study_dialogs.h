#pragma once

#include <string>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QSpinBox>

#include "study/gui/desk/study_summary.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"
#include "study/session/verification.h"

namespace study::gui {

/// Copies a study to a new folder and reads the copy again.
class BackupDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit BackupDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  std::string folder_;
  PathField* target_;
};

/// Reads a study to its last byte and says check by check whether it holds.
class VerifyDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit VerifyDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  std::string folder_;
};

/// Writes the page for a paper.
class ReportDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit ReportDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  /// Live sessions are unblinded with a reason only.
  void updateChoices();

  std::string folder_;
  QComboBox* mode_;
  QComboBox* language_;
  QLineEdit* reason_;
  PathField* target_;
};

/// All checks as lines: "✓ the audit trail is unbroken", and what is wrong below those that fail.
QString describe(const Verification& verification);

/// A choice of the sessions that count, with how many of each there are.
QComboBox* runModeChoice(const StudySummary& study, QWidget* parent);
RunMode chosenMode(const QComboBox& choice);

/// A name for something new beside a study: "/home/a/my-study-report".
QString beside(const std::string& folder, const QString& ending);

}  // namespace study::gui
