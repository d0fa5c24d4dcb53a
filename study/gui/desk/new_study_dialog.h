#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>

#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/authoring/file_watch.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"

namespace study::gui {

/// Creates a study from a built-in protocol or a protocol file. A file is checked when it is chosen
/// and after each change.
class NewStudyDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit NewStudyDialog(QWidget* parent = nullptr);

  /// Selects a protocol file.
  void setProtocolFile(const QString& file);

 signals:
  void created(const QString& folder);
  /// The user wants to see the protocol's text beside its problems.
  /// @param shown  the protocol with the texts that were filled in; nullptr: it has errors
  void protocolRequested(const QString& source, const protocols::LoadedProtocol* shown);

 protected:
  void work() override;

 private:
  QString source() const;
  void check();
  void showChecked();
  void updateButton();
  /// Opens the form for the protocol's blanks. The study will be created with the texts of the
  /// form.
  void fillInTexts();

  CheckedProtocol checked_;
  FileWatch watch_;
  QComboBox* protocol_;
  PathField* file_;
  PathField* folder_;
  QCheckBox* advanced_;
  QLineEdit* seed_;
  QPushButton* checkProtocolButton_;
  QPushButton* previewButton_;
  QPushButton* fillButton_;
};

}  // namespace study::gui
