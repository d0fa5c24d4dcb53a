#pragma once

#include <span>
#include <string_view>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QTextBrowser>

namespace study::gui {

/// A window of the program.
struct ProgramWindow {
  std::string_view name;   ///< of its class, which may be Qt's own
  std::string_view topic;  ///< part of the heading that F1 shows; empty: no help, or that of the
                           ///< window that opened this one
};

/// Every window and dialog of the program.
std::span<const ProgramWindow> programWindows() noexcept;

/// Shows the documentation that was built into the program.
class HelpWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent = nullptr);

  /// Shows "Running a study" at the heading that contains @p topic, or at its beginning if none
  /// does; for a topic such as "devices.md#Real time" that page.
  void showTopic(const QString& topic);

  /// The heading on display.
  QString heading() const { return heading_; }

 protected:
  /// Scales pictures to the width of the text.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void listHeadings();
  void fitToWidth();
  void goTo(int block);
  void search();

  QLineEdit* searchField_;  ///< words to look for in the text
  QLabel* searchResult_;    ///< says so if they are not there
  QListWidget* contents_;
  class Text;
  Text* text_;
  QString heading_;
};

/// Opens help on F1 in every window except the participant's. The topic is the widget's property
/// "help", or else that of its window.
void installHelpKey(QApplication& application);

/// The topic that F1 shows for @p widget; empty if there is no help.
QString helpTopicOf(const QWidget& widget);

/// The window that F1 opened last; nullptr before the first.
HelpWindow* openHelp() noexcept;

/// Opens help on a topic, near the window of @p beside if it is not nullptr.
void showHelp(const QString& topic, const QWidget* beside = nullptr);

}  // namespace study::gui
