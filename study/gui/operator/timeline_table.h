#pragma once

#include <QTableWidget>

#include "study/gui/session/session_controller.h"

namespace study::gui {

/// The steps of a session in their order, each with its attempts and how it stands. Names
/// alternatives as the participant knows them, and no condition.
class TimelineTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit TimelineTable(QWidget* parent = nullptr);

  /// Shows where the session is; empty where there is none.
  void show(const SessionController* controller);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fillRow(int row, const SessionController& controller);
  void write(int row, int column, const QString& words, bool isNow);
};

}  // namespace study::gui
