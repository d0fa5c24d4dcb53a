#pragma once

#include <vector>

#include <QButtonGroup>
#include <QPushButton>
#include <QString>
#include <QWidget>

namespace study::gui {

/// Some buttons of which one may be chosen; none is at first.
///
/// Space, Enter or a digit chooses; the arrow keys only move, so that a stray key alters no answer.
class OptionButtons final : public QWidget {
  Q_OBJECT

 public:
  struct Option {
    QString text;            ///< on the button
    QString accessibleName;  ///< what a screen reader says
  };

  /// @param role  of the buttons in the style sheet: "point", "option".
  OptionButtons(
      const std::vector<Option>& options,
      Qt::Orientation orientation,
      const QString& role,
      QWidget* parent = nullptr);

  /// −1 while nothing is chosen.
  int chosen() const { return group_->checkedId(); }
  void choose(int index);
  QPushButton* button(int index) const { return buttons_[static_cast<std::size_t>(index)]; }

 signals:
  /// Also where a screen reader chose it.
  void chosenChanged(int index);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool moveFocus(int from, int key);

  QButtonGroup* group_;
  std::vector<QPushButton*> buttons_;
};

}  // namespace study::gui
