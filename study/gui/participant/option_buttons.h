#pragma once

#include <vector>

#include <QButtonGroup>
#include <QGridLayout>
#include <QPushButton>
#include <QString>
#include <QWidget>

namespace study::gui {

/// A grid of buttons of which at most one is chosen. None is chosen at first. Options have a ring,
/// as a radio button does, and that of the chosen one is filled; a chosen number has a check mark.
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

  static constexpr int kAsManyAsFit = 0;

  /// @param columns  number of columns of the grid, which is filled row by row; kAsManyAsFit: as
  ///     the width allows, in rows of equal length as far as possible.
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

  /// Makes the buttons large, for a page that asks only this question.
  void makeLarge();

  QSize minimumSizeHint() const override;

 signals:
  /// Emitted also when a screen reader chose the option.
  void chosenChanged(int index);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool moveFocus(int from, int key);
  int widestButton() const;
  int columnsAt(int width) const;
  void fill(int columns);

  QButtonGroup* group_;
  QGridLayout* grid_;
  bool isFlexible_;  ///< has as many columns as fit
  int columns_ = 0;
  std::vector<QPushButton*> buttons_;
};

}  // namespace study::gui
