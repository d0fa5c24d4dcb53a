#pragma once

#include <QLineEdit>
#include <QWidget>

namespace study::gui {

/// The path @p start with @p extension, with a number if that path exists: "my-cut.json",
/// "my-cut-2.json".
QString unusedPath(const QString& start, const QString& extension = {});

/// The user's folder of documents; the home folder if there is none.
QString documentsFolder();

/// A line edit for a path, with a button that opens a file dialog.
class PathField final : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { ExistingFile, ExistingFolder, NewFile, NewFolder };

  /// @param filter  for files, in the syntax of QFileDialog: "Protocols (*.json)".
  PathField(Kind kind, const QString& name, const QString& filter = {}, QWidget* parent = nullptr);

  QString path() const { return line_->text().trimmed(); }
  void setPath(const QString& path) { line_->setText(path); }
  /// Sets the text that is shown as long as no path is entered.
  void setHint(const QString& hint) { line_->setPlaceholderText(hint); }
  /// Sets the folder in which the file dialog opens as long as no path is entered; at first it is
  /// the folder of documents.
  void startIn(const QString& folder) { start_ = folder; }
  /// Opens the desktop's chooser for a path.
  void choose();

 signals:
  void pathChanged(const QString& path);

 private:
  Kind kind_;
  QString name_;
  QString filter_;
  QString start_;
  QLineEdit* line_;
};

}  // namespace study::gui
