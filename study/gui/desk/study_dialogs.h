#pragma once

#include <string>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>

#include "study/gui/desk/study_summary.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"
#include "study/gui/widgets/written_file.h"
#include "study/session/verification.h"

namespace study::gui {

/// Copies a study to a new folder and verifies the copy.
class BackupDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit BackupDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  void updateChoices();

  std::string folder_;
  PathField* target_;
  QLabel* sameDisk_ = nullptr;  ///< warns that the target is on the disk of the study
};

/// Verifies a whole study and lists the result of each check. If the audit trail
/// ends before the last entry that this station signed, the user can record that a backup was
/// restored.
class VerifyDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit VerifyDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  void recordRestoredBackup();

  std::string folder_;
  QPushButton* restoredButton_;
};

/// Writes the report of a study.
class ReportDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit ReportDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  void addFigures();
  /// Asks for a reason where live or pilot sessions would be unblinded.
  void updateChoices();

  std::string folder_;
  QComboBox* mode_;
  QComboBox* language_;
  QComboBox* wording_;
  QComboBox* paper_;
  QCheckBox* quotes_;
  PathField* target_;
  QCheckBox* figures_;
  QSpinBox* width_;
  QDoubleSpinBox* font_;
  WrittenFile* writtenFigures_;
};

/// All checks, with what was found below each: "✓ The audit trail is unbroken".
std::vector<Note> notesOf(const Verification& verification);

/// A list of run modes to choose from, each with its number of sessions.
QComboBox* makeRunModeBox(const StudySummary& study, QWidget* parent);
/// Whether there are sessions of the chosen mode.
bool hasSessions(const QComboBox& choice);
/// Why nothing can be done with a mode that has no sessions.
QString noSessionsText();
RunMode chosenMode(const QComboBox& choice);

/// An unused path for a new file or folder next to a study, with today's date:
/// "/home/a/my-study-report-2026-11-23.html", "…-2026-11-23-2.html".
QString unusedPathBeside(
    const std::string& folder, const QString& what, const QString& extension = {});

/// A place where a file system is mounted.
struct MountedDisk {
  QString root;
  QByteArray device;
  bool isWritable = false;
};
/// The root of the first disk that is not @p device, can be written to and is mounted where a
/// desktop mounts sticks and drives: below /media, /run/media or /mnt; empty if there is none.
QString diskApartFrom(const QByteArray& device, const std::vector<MountedDisk>& disks);

/// A path of that name on another disk than the study's; in the user's home folder, if none is
/// mounted.
QString pathApart(const std::string& folder, const QString& what, const QString& extension = {});
/// Whether a new file or folder would be on the same file system as the study.
bool isOnDiskOf(const std::string& folder, const QString& path);

/// The folder in which a study is; the user's documents if nothing can be written there.
QString folderBeside(const std::string& folder);

}  // namespace study::gui
