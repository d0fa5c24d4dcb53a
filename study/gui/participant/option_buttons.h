#pragma once

#include <vector>

#include <QButtonGroup>
#include <QPushButton>
#include <QString>
#include <QWidget>

namespace study::gui {

/// A grid of buttons of which at most one is chosen. None is chosen at first. Each has a ring, as a
/// radio button does; that of the chosen one is filled.
///
/// Space, Enter or a digit chooses. Arrow keys only move the focus, so that a stray key changes no
/// answer.
class OptionButtons final : public QWidget {
  Q_OBJECT

 public:
  struct Option {
    QString text;            ///< on the button
    QString accessibleName;  ///< what a screen reader says
  };

  /// @param columns  number of columns of the grid, which is filled row by row.
  /// @param role  the buttons' role in the style sheet: "point" or "option".
  OptionButtons(
      const std::vector<Option>& options,
      int columns,
      const QString& role,
      QWidget* parent = nullptr);

  /// The index of the chosen option; −1 while none is chosen.
  int chosen() const { return group_->checkedId(); }
  void choose(int index);
  QPushButton* button(int index) const { return buttons_[static_cast<std::size_t>(index)]; }

 signals:
  /// Emitted also when a screen reader chose the option.
  void chosenChanged(int index);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool moveFocus(int from, int key);

  QButtonGroup* group_;
  int columns_;
  std::vector<QPushButton*> buttons_;
};

/// The number of columns for options: several if all texts are short, one if a text is long.
int columnsFor(const std::vector<OptionButtons::Option>& options);

}  // namespace study::gui
