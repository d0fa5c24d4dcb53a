#pragma once

#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <QWidget>

#include "study/model/data_table.h"

namespace study::gui {

/// What was computed: the answer in words, and below it tables, one at a time, that can be copied
/// or saved.
class ResultView final : public QWidget {
  Q_OBJECT

 public:
  explicit ResultView(QWidget* parent = nullptr);

  /// @param tables  of texts; chosen by their descriptions
  void show(const QString& answer, std::vector<DataTable> tables);
  using QWidget::show;

  /// The table in sight. Must not be called where there is none.
  const DataTable& table() const {
    return tables_[static_cast<std::size_t>(choice_->currentIndex())];
  }
  /// Saves the table in sight as CSV. Throws if there is such a file or it cannot be written.
  void saveTo(const QString& path) const;

 private:
  void fill();
  /// Copies the selected cells; all with their headings if none are selected.
  void copy() const;
  void save();

  std::vector<DataTable> tables_;
  QLabel* answer_;
  QWidget* results_;  ///< the tables; hidden where there are none
  QComboBox* choice_;
  QTableWidget* cells_;
};

}  // namespace study::gui
