#pragma once

#include <vector>

#include <QTableWidget>

#include "study/model/data_table.h"

namespace study::gui {

/// A table of texts. Columns are as wide as their words, up to a limit; those with more words share
/// the room that is left, or all do. Where rows that follow each other begin with the same words,
/// these are above them, once, with what else is the same in all of these rows.
class ResultTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit ResultTable(QWidget* parent);

  void show(const DataTable& table);
  using QWidget::show;

  /// The height of all rows with the headings [px].
  int wholeHeight() const;
  /// The selected cells as lines with tabs, without headings; all cells if @p isAll.
  QStringList lines(bool isAll) const;

 signals:
  void copyRequested();
  /// The widths of the columns, and so the heights of the rows, have changed.
  void columnsFitted();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void fill(const DataTable& table);
  void addHeading(const QString& words);
  void addRow(const std::vector<QString>& cells, const DataTable& table);
  void fitColumns();
};

}  // namespace study::gui
