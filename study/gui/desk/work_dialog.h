#pragma once

#include <QDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "study/gui/widgets/field_form.h"

namespace study::gui {

/// A dialog with a form, a button that does the work, and the result. On a low screen the form and
/// the result are scrolled; the buttons stay in sight.
class WorkDialog : public QDialog {
  Q_OBJECT

 public:
  /// The kind of result. Each has a symbol as well as a colour.
  enum class Outcome { Good, Warning, Bad };

 protected:
  WorkDialog(const QString& title, const QString& what, const QString& verb, QWidget* parent);

  FieldForm& form() noexcept { return *form_; }
  QPushButton& runButton() noexcept { return *runButton_; }

  /// Enables the button, or says beside it what has to be done before.
  /// @param obstacle  "Give a reason."; empty: none
  void setObstacle(const QString& obstacle);

  /// Shows the result in one line, and details below.
  void showOutcome(Outcome outcome, const QString& line, const QString& more = {});
  /// The same for something that was written, which can be opened from here. The button that wrote
  /// it is no longer the main one.
  void showWrittenFile(
      const QString& path,
      const QString& line,
      const QString& more = {},
      Outcome outcome = Outcome::Good);
  /// Places pictures beside the form; below it where the dialog is narrow.
  void addBeside(QBoxLayout* pictures);
  /// Places a widget of the dialog's own where details are.
  void addResult(QWidget* result);
  /// Shows details without a result.
  void showDetails(const QString& more);
  void clear();
  /// Resizes the dialog to its contents, as far as the screen has room.
  void fit();

  /// Called when the button is pressed.
  virtual void work() = 0;

  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QHBoxLayout* makeButtons();
  void fitDetails();
  void orderStops();

  QScrollArea* scroll_;
  FieldForm* form_;
  QBoxLayout* body_ = nullptr;      ///< the form, with pictures beside it
  QBoxLayout* pictures_ = nullptr;  ///< nullptr: there are none
  QLabel* line_;
  class WrittenFile* written_;
  QTextBrowser* details_;
  QLabel* obstacle_;
  QPushButton* runButton_;
};

}  // namespace study::gui
