#pragma once

#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace study::gui {

/// A few questions, a button that does the work, and what came of it, in one window.
class WorkDialog : public QDialog {
  Q_OBJECT

 public:
  /// How it came out; each has a sign of its own beside its colour.
  enum class Outcome { Good, Warning, Bad };

 protected:
  WorkDialog(const QString& title, const QString& what, const QString& verb, QWidget* parent);

  QFormLayout& form() noexcept { return *form_; }
  QPushButton& go() noexcept { return *go_; }

  /// Says how it came out, in a line, and more about it below.
  void say(Outcome outcome, const QString& line, const QString& more = {});
  /// Shows words below without an outcome.
  void tellMore(const QString& more);
  void clear();
  /// Makes room for what is shown now.
  void fit();

  /// Runs when the button is pressed.
  virtual void work() = 0;

  void showEvent(QShowEvent* event) override;

 private:
  QFormLayout* form_;
  QLabel* line_;
  QTextBrowser* more_;
  QPushButton* go_;
};

}  // namespace study::gui
