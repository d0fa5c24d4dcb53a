#pragma once

#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "study/gui/widgets/note_list.h"
#include "study/model/data_table.h"
#include "study/report/study_parts.h"

namespace study::gui {

class ResultTable;

/// Shows a result: the finding; below it tables, one at a time, which can be copied or saved; and
/// the rest of the answer in words, with caveats.
class ResultView final : public QWidget {
  Q_OBJECT

 public:
  explicit ResultView(QWidget* parent = nullptr);

  /// @param tables  of texts; chosen by their descriptions
  void show(const report::Answer& answer, std::vector<DataTable> tables);
  using QWidget::show;

  /// The table that is shown. Must not be called if there is no table.
  const DataTable& table() const {
    return tables_[static_cast<std::size_t>(choice_->currentIndex())];
  }
  /// Saves the table in sight as CSV. Throws if there is such a file or it cannot be written.
  void saveTo(const QString& path) const;

  /// The height that the table was given [px]; 0 without one.
  int tableHeight() const { return tables_.empty() ? 0 : tableHeight_; }
  /// Gives the table @p room [px]. If that is too little for some rows, the table is as high as all
  /// of its rows, so that only the page around it is scrolled.
  void giveTableRoom(int room);

 signals:
  /// The table needs another height.
  void tableChanged();

 private:
  void fill();
  /// Copies the selected cells; all with their headings if none are selected.
  void copy() const;
  void save();

  std::vector<DataTable> tables_;
  QLabel* finding_;
  QLabel* more_;
  QWidget* results_;   ///< the tables; hidden where there are none
  QLabel* title_;      ///< of the only table
  QComboBox* choice_;  ///< of several
  ResultTable* cells_;
  int tableHeight_ = 0;
  QLabel* caveatsHeading_;
  NoteList* caveats_;
};

}  // namespace study::gui
