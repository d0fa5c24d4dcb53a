#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QWidget>

namespace study::gui {

/// The layout of a page on which something is felt: a panel as high as the page, and beside it the
/// title, what to do, what was done, and the button that goes on, at the place of Next on other
/// pages. In an upright window the panel is between the words and the button.
class Stage final : public QWidget {
  Q_OBJECT

 public:
  enum class Panel {
    Picture,  ///< needed for the page: always shown
    Card,     ///< left out in a low window
  };

  /// @param shown  in the panel, of which the stage takes ownership; nullptr: there is no panel.
  Stage(const QString& title, QWidget* shown, Panel panel, QWidget* parent = nullptr);

  QLabel& title() noexcept { return *title_; }
  /// Writes below the picture on a card what it shows; the picture then leaves room for the words.
  void setCaption(const QString& caption);
  /// What to do, below the title.
  QVBoxLayout& words() noexcept { return *words_; }
  /// Puts @p counter below the words, or beside the title if the panel is between.
  void setCounter(QWidget* counter);
  /// Adds a button at the end of the foot.
  void addButton(QPushButton* button);
  /// How to pause or stop, on every page.
  QLabel& stopHint() noexcept { return *stopHint_; }
  /// Why the button cannot be pressed yet; empty: it can.
  void setReason(const QString& reason);

  bool isSideBySide() const noexcept { return isWide_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void arrange();
  void place(bool isWide);
  int heightOfWords(int width) const;

  Panel kind_;
  QGridLayout* grid_;
  QWidget* panel_;  ///< nullptr: none
  QScrollArea* scroll_;
  QGridLayout* column_;  ///< in the scroll area: title, words, counter
  QLabel* title_;
  QWidget* body_;
  QVBoxLayout* words_;
  QWidget* counter_ = nullptr;
  QLabel* stopHint_ = nullptr;
  QWidget* foot_;
  QLabel* reason_;
  QGridLayout* footRows_;
  QBoxLayout* buttons_;
  bool isWide_ = false;
};

}  // namespace study::gui
