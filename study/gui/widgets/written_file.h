#pragma once

#include <QString>
#include <QWidget>

namespace study::gui {

/// A path for display, with "~" for the home folder: "~/studies/punch".
QString shownPath(const QString& path);

/// Opens a file or a folder in the program that the desktop has for it.
void openOnDesktop(const QString& path, QWidget* parent);

/// Shows a message that @p path was written, with buttons that open it or its folder. Returns at
/// once. @param more  shown below it
void showWrittenFileMessage(QWidget* parent, const QString& path, const QString& more = {});

/// Two buttons for something that was written: *Open*, and *Show in folder*.
class WrittenFile final : public QWidget {
  Q_OBJECT

 public:
  explicit WrittenFile(QWidget* parent = nullptr);

  /// Sets the file or folder; empty: the buttons are hidden.
  void show(const QString& path);
  using QWidget::show;
  const QString& path() const noexcept { return path_; }

 private:
  QString path_;
};

}  // namespace study::gui
