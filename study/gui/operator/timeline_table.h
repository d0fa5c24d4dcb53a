#pragma once

#include <QTableWidget>

#include "study/gui/session/session_controller.h"

namespace study::gui {

/// The steps of a session in order, each with its attempts and status. It shows the alternatives by
/// the participant's labels and never the conditions.
class TimelineTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit TimelineTable(QWidget* parent = nullptr);

  /// Shows the steps of @p controller's session; nullptr: an empty table.
  void show(const SessionController* controller);
  /// Whether it scrolls; otherwise it is as high as its rows, and what it lies in is scrolled.
  void scrollItself(bool does);

  static constexpr int kLeastHeight = 130;  ///< [px] of one that scrolls: three steps

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  int widthOfStatus() const;
  void fitHeight();
  void fillRow(int row, const SessionController& controller);
  void write(int row, int column, const QString& words, bool isNow);

  bool scrollsItself_ = true;
};

}  // namespace study::gui
