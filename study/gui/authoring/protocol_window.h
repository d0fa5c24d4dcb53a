#pragma once

#include <optional>

#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>

#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/authoring/file_watch.h"

namespace study::gui {

class TimelinePage;
class OrdersPage;

/// Shows a protocol to its author: a summary in words, a session's timeline, each participant's
/// order, all problems, and on request the text with the line of a problem. It reloads the file
/// after each change, and writes it only when its blanks are filled in.
class ProtocolWindow final : public QMainWindow {
  Q_OBJECT

 public:
  /// @param source  a path, or the name of a built-in protocol.
  explicit ProtocolWindow(const QString& source, QWidget* parent = nullptr);

  /// Shows the protocol with the texts of @p filled where the file leaves them empty.
  void keepTextsOf(const protocols::LoadedProtocol& filled);

  const CheckedProtocol& checked() const noexcept { return checked_; }
  /// The highlighted line, from 0; −1: none.
  int markedLine() const noexcept { return markedLine_; }

 public slots:
  /// Reads the file again.
  void reload();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void prepareText();
  QWidget* makeSummary();
  QWidget* makeProblems();
  void prepareProblems();
  QHBoxLayout* makeHead();
  QHBoxLayout* makeButtons();
  void connectAll();
  bool hasWeaknesses() const;
  QString gravestProblem() const;
  QString placeOf(const questionnaires::Problem& problem) const;
  void showVerdict();
  void showProblems();
  void showText();
  void mark(int line);
  void goToProblem(int row);
  QStringList filesToWatch() const;
  bool isShipped() const;
  /// Saves the shipped protocol as one of the user's own, and shows that.
  void saveAs();
  void showSource(const QString& source);
  /// Opens the form for the blanks, and saves the protocol with its texts. A file of the user is
  /// replaced; a built-in protocol is saved as a new file.
  void fillInTexts();

  QString source_;
  std::optional<protocols::LoadedProtocol> filled_;  ///< see keepTextsOf()
  CheckedProtocol checked_;
  FileWatch watch_;
  QLabel* title_;
  QLabel* verdict_;
  QLabel* readAtLabel_;
  QPushButton* previewButton_;
  QPushButton* fillButton_;
  QPushButton* copyButton_;  ///< of a shipped protocol
  QPushButton* showSourceButton_;
  QLabel* summary_;
  QPlainTextEdit* text_;  ///< hidden until it is asked for
  QLabel* aboutProblems_;
  QTableWidget* problems_;
  QTabWidget* pages_;
  TimelinePage* timeline_;
  OrdersPage* orders_;
  int markedLine_ = -1;
};

}  // namespace study::gui
