#pragma once

#include <QApplication>
#include <QListWidget>
#include <QMainWindow>
#include <QTextBrowser>

namespace study::gui {

/// The documentation as it was when the program was built, beside the windows that it is about.
class HelpWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent = nullptr);

  /// Shows "Running a study" at the heading that holds @p topic; from its beginning where none
  /// does.
  void showTopic(const QString& topic);

  /// The heading that is shown.
  QString heading() const { return heading_; }

 protected:
  /// Pictures follow the width of the text.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void listHeadings();
  void fitToWidth();
  void goTo(int block);

  QListWidget* contents_;
  QTextBrowser* text_;
  QString heading_;
};

/// Opens help on F1 in every window of the desk; nothing happens in the participant's. A widget
/// with the property "help" is about that topic; others are about what their window is.
void offerHelp(QApplication& application);

/// What F1 shows in @p widget; nothing where there is no help to be had.
QString helpTopicOf(const QWidget& widget);

/// The window that F1 opened last; nothing before.
HelpWindow* openHelp() noexcept;

/// Opens help on a topic, as F1 does in @p beside.
void showHelp(const QString& topic, const QWidget* beside = nullptr);

}  // namespace study::gui
