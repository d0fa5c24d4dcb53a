#pragma once

#include <QString>
#include <QWidget>

namespace study::gui {

/// A path as people read it: "~/studies/punch" in the user's own folder.
QString shownPath(const QString& path);

/// Opens a file or a folder in the program that the desktop has for it.
void openOnDesktop(const QString& path);

/// Says that @p path was written, and offers to open it or its folder. Does not wait.
void announceWrittenFile(QWidget* parent, const QString& path);

/// Two buttons for something that was written: *Open*, and *Show in folder*.
class WrittenFile final : public QWidget {
  Q_OBJECT

 public:
  explicit WrittenFile(QWidget* parent = nullptr);

  /// A file, or a folder; empty: the buttons are hidden.
  void show(const QString& path);
  using QWidget::show;
  const QString& path() const noexcept { return path_; }

 private:
  QString path_;
};

}  // namespace study::gui
