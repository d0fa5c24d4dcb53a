#pragma once

#include <QLineEdit>
#include <QWidget>

namespace study::gui {

/// A path to be written or chosen.
class PathField final : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { ExistingFile, ExistingFolder, NewFile, NewFolder };

  /// @param filter  of files, as Qt's file dialog takes it: "Protocols (*.json)".
  PathField(Kind kind, const QString& name, const QString& filter = {}, QWidget* parent = nullptr);

  QString path() const { return line_->text().trimmed(); }
  void setPath(const QString& path) { line_->setText(path); }

 signals:
  void pathChanged(const QString& path);

 private:
  void choose();

  Kind kind_;
  QString name_;
  QString filter_;
  QLineEdit* line_;
};

}  // namespace study::gui
