#pragma once

#include <QComboBox>
#include <QLineEdit>

#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/authoring/file_watch.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"

namespace study::gui {

/// Makes a study from a protocol: one that ships, or a file, which is checked as soon as it is
/// named and again whenever it changes.
class NewStudyDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit NewStudyDialog(QWidget* parent = nullptr);

  /// Takes a protocol file of one's own.
  void setProtocolFile(const QString& file);

 signals:
  void created(const QString& folder);
  /// Somebody wants to see the protocol's text and problems side by side.
  void protocolRequested(const QString& source);

 protected:
  void work() override;

 private:
  QString source() const;
  void check();

  CheckedProtocol checked_;
  FileWatch watch_;
  QComboBox* protocol_;
  PathField* file_;
  PathField* folder_;
  QLineEdit* seed_;
  QPushButton* read_;
};

}  // namespace study::gui
