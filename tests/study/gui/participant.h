#pragma once

#include <functional>
#include <set>
#include <string>

#include <QPushButton>
#include <QString>
#include <QWidget>

#include "study/gui/operator/operator_window.h"

namespace tests {

/// A simulated user of the participant's window. It clicks, types and cuts, and collects all
/// visible text.
class Participant {
 public:
  explicit Participant(study::gui::OperatorWindow& window) : window_(window) {}

  /// From now on these words are typed into every field that takes words.
  void writes(const QString& words) { words_ = words; }

  /// Takes the session to its end, or until step @p stopBefore begins.
  void takePart(int stopBefore = -1);

  /// Takes the session to its first step of kind @p kind.
  void goTo(study::StepKind kind);

  /// Does one step: reads the page, answers all its items, and goes on.
  void doStep();
  /// Begins the trial and makes @p cuts cuts with the space bar, without ending the trial.
  void cut(int cuts);
  /// Reads the page.
  void look();

  /// All texts that appeared in the participant's window: labels, buttons, titles, accessible
  /// names, tool tips, object names.
  const std::set<QString>& seen() const noexcept { return seen_; }
  /// All texts that appeared in the operator's window at the same times.
  const std::set<QString>& seenByOperator() const noexcept { return seenByOperator_; }

 private:
  QWidget* page() const;

  void answerAll();
  void doInterview();
  void goOn();
  void photograph();
  bool waitFor(const std::function<bool()>& condition, int milliseconds) const;

  study::gui::OperatorWindow& window_;
  QString words_;
  std::set<QString> seen_;
  std::set<QString> seenByOperator_;
  int pictures_ = 0;
};

/// Saves a picture of a window as NAME.png if PALPATE_PICTURES=FOLDER is set.
void photograph(QWidget& window, const QString& name);

/// Chooses the first cohort for the next participant.
void chooseFirstCohort(study::gui::OperatorWindow& window);

/// The visible button with @p text in @p parent; nullptr if there is none.
QPushButton* buttonSaying(QWidget* parent, const QString& text);

}  // namespace tests
