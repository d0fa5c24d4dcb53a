#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "study/gui/widgets/field_form.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/note_list.h"
#include "study/gui/widgets/result_view.h"

namespace study::gui {

/// A dialog with a form, a button that does the work, and the result. It is as high as what it
/// shows, as far as the screen has room; what does not fit is scrolled, and the buttons stay in
/// sight.
class WorkDialog : public QDialog {
  Q_OBJECT

 public:
  /// The kind of result.
  using Outcome = Mark;

 protected:
  WorkDialog(const QString& title, const QString& what, const QString& verb, QWidget* parent);

  FieldForm& form() noexcept { return *form_; }
  QPushButton& runButton() noexcept { return *runButton_; }

  /// Enables the button, or says beside it what has to be done before.
  /// @param obstacle  "Give a reason."; empty: none
  void setDisabledReason(const QString& obstacle);

  /// Adds a row with the reason for the work, which goes into the audit trail.
  /// @param changed  called when it is changed
  void addReason(
      const QString& label, const std::function<void()>& changed, const QString& hint = {});
  void showReason(bool isShown) { form_->setRowVisible(reason_, isShown); }
  /// The reason; empty if its row is not shown.
  std::string reason() const;
  /// Adds a row with a hint on the field above it.
  QLabel* addHint(const QString& words);
  /// Shows a notice above the form, which the user should read before the work is begun.
  void showNotice(Mark mark, const QString& line);
  /// Shows the result in one line, and details below. After a good result the button no longer has
  /// the style of the main button.
  void showOutcome(Outcome outcome, const QString& line, const std::vector<Note>& more = {});
  /// The same for something that was written, which can be opened from here.
  void showWrittenFile(
      const QString& path,
      const QString& line,
      const std::vector<Note>& more = {},
      Outcome outcome = Outcome::Good);
  /// Places pictures beside the form; below it where the dialog is narrow.
  void addBeside(QBoxLayout* pictures);
  /// Places tables below the result. They get the height that the screen has left.
  void addResult(ResultView* result);
  /// Shows details without a result.
  void showDetails(const std::vector<Note>& more);
  void clear();
  /// Gives the button the style of the main button, or takes it away, as after the work is done.
  void setMain(bool isMain);
  /// Makes the dialog wide enough for tables, as far as the screen has room.
  /// @param width  [px]
  void widen(int width);
  /// Resizes the dialog to its contents, as far as the screen has room. A dialog that the user has
  /// resized is only enlarged.
  void fit();

  /// Called when the button is pressed.
  virtual void work() = 0;

  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QHBoxLayout* makeButtons();
  void orderTabStops();
  int heightOfPage() const;
  void fitTable(int room);
  int wantedHeight();
  void fitTo(int height);
  void keepOnScreen();

  QScrollArea* scroll_;
  FieldForm* form_;
  QBoxLayout* body_ = nullptr;      ///< the form, with pictures beside it
  QBoxLayout* pictures_ = nullptr;  ///< nullptr: there are none
  QLineEdit* reason_ = nullptr;     ///< nullptr: none is asked for
  QLabel* notice_;
  QLabel* outcomeLine_;
  class WrittenFile* writtenFile_;
  NoteList* details_;
  ResultView* result_ = nullptr;  ///< nullptr: the dialog has no tables
  QLabel* disabledReason_;
  QPushButton* runButton_;
  int fittedHeight_ = 0;  ///< the height that fit() gave the dialog [px]
};

}  // namespace study::gui
