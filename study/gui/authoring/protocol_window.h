#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QTableWidget>

#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/authoring/file_watch.h"

namespace study::gui {

class TimelinePage;
class OrdersPage;

/// A protocol as its author wants to see it: the text, the day of a participant, everybody's order,
/// and all problems, each at its place. Read anew whenever the file changes; it changes nothing
/// itself.
class ProtocolWindow final : public QMainWindow {
  Q_OBJECT

 public:
  /// @param source  a file, or the name of a protocol that ships.
  explicit ProtocolWindow(const QString& source, QWidget* parent = nullptr);

  const CheckedProtocol& checked() const noexcept { return checked_; }
  /// The line that is marked, from 0; nothing is marked: -1.
  int markedLine() const noexcept { return marked_; }

 public slots:
  /// Reads the file now.
  void reload();

 signals:
  void reloaded();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void prepareText();
  void prepareProblems();
  void showVerdict();
  void showProblems();
  void showText();
  void mark(int line);
  void goToProblem(int row);
  QStringList filesToWatch() const;

  QString source_;
  CheckedProtocol checked_;
  FileWatch watch_;
  QLabel* verdict_;
  QLabel* readAt_;
  QPlainTextEdit* text_;
  QTableWidget* problems_;
  QTabWidget* pages_;
  TimelinePage* timeline_;
  OrdersPage* orders_;
  int marked_ = -1;
};

}  // namespace study::gui
