#pragma once

#include <functional>
#include <set>
#include <string>

#include <QPushButton>
#include <QString>
#include <QWidget>

#include "study/gui/operator/operator_window.h"

namespace tests {

/// Somebody at the participant's window: clicks, types and cuts as people do, and remembers every
/// word that was to be seen.
class Participant {
 public:
  explicit Participant(study::gui::OperatorWindow& window) : window_(window) {}

  /// Takes the session from where it is to its end, or until @p stopBefore begins.
  void takePart(int stopBefore = -1);

  /// Takes the session to the first step of such a kind.
  void goTo(study::StepKind kind);

  /// One step: reads the page, answers all of it, goes on.
  void doStep();
  /// Begins the trial on the page and makes so many cuts with the space bar; does not end it.
  void cut(int cuts);
  /// Reads the page.
  void look();

  /// Everything that was written anywhere in the participant's window: labels, buttons, titles,
  /// names for screen readers, tool tips, object names.
  const std::set<QString>& seen() const noexcept { return seen_; }
  /// … and in the operator's, at the same times.
  const std::set<QString>& seenByOperator() const noexcept { return seenByOperator_; }

 private:
  QWidget* page() const;

  void answerAll();
  void doInterview();
  void photograph();
  bool waitFor(const std::function<bool()>& condition, int milliseconds) const;

  study::gui::OperatorWindow& window_;
  std::set<QString> seen_;
  std::set<QString> seenByOperator_;
  int pictures_ = 0;
};

/// With PALPATE_PICTURES=FOLDER saves how a window looks as NAME.png there.
void photograph(QWidget& window, const QString& name);

/// The button in @p parent that says @p text; nullptr where there is none to be seen.
QPushButton* buttonSaying(QWidget* parent, const QString& text);

}  // namespace tests
