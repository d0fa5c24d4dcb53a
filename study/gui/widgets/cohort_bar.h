#pragma once

#include <QString>
#include <QWidget>

namespace study::gui {

/// Shows the progress of a cohort as text and as a bar: "Orthopaedic surgeons: 3 of 12 completed".
class CohortBar final : public QWidget {
  Q_OBJECT

 public:
  /// @param planned  0: no number is planned, and there is no bar.
  CohortBar(const QString& title, int completed, int planned, QWidget* parent = nullptr);
};

}  // namespace study::gui
