#pragma once

#include <optional>

#include <QString>
#include <QTableWidget>

namespace study::gui {

/// The studies of this computer, one row each: the title, below it the folder and the day on which
/// the study was last opened, and below that its progress. The list is as high as its rows, if
/// there is room.
class StudyList final : public QTableWidget {
  Q_OBJECT

 public:
  struct Row {
    QString title;
    QString place;                ///< the folder's name, and the day on which it was last opened
    QString progress;             ///< "3 of 11 completed; 1 unfinished"
    std::optional<double> share;  ///< of the planned sessions that are completed, 0 to 1
    bool isBroken = false;        ///< the study cannot be opened
  };
  /// The role of Row::share in an item; no bar without it.
  static constexpr int kShareRole = Qt::UserRole;

  explicit StudyList(QWidget* parent = nullptr);

  void setRow(int row, const Row& shown);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void updateGeometries() override;

 private:
  int heightOfRows() const;
};

}  // namespace study::gui
