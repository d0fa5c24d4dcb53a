#pragma once

#include <string>
#include <vector>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QStackedWidget>
#include <QWidget>

#include "haptics/recordings/recording_table.h"

namespace study::gui {

/// Asks which columns of a table are its time, travel and force, and in which units; for a table
/// without a time, how many rows a second has. A columns file says the same, and can also name a
/// calibration and lines to skip.
class ColumnsForm final : public QWidget {
  Q_OBJECT

 public:
  explicit ColumnsForm(QWidget* parent = nullptr);

  /// Offers the columns of the table in @p file, chosen by their headings where these have units.
  /// @return whether it is a table of at least two columns of numbers
  bool offerColumnsOf(const std::string& file);
  /// Whether no column is the time, and the rate of the rows is not given either.
  bool lacksRate() const;
  haptics::recordings::RecordingColumns columns() const;

 signals:
  void changed();

 private:
  /// Sets the open and the closed travel to the ends of the chosen travel column.
  void measureTravel();
  /// Whether a column is chosen for the time, and not "evenly spaced rows" below them.
  bool hasTime() const;
  void showUnitOrRate();

  std::vector<std::vector<std::string>> rows_;  ///< cells; the first row may be the headings
  char separator_ = ',';
  std::size_t headingLine_ = 0;  ///< number of the line with the headings; 0: there is none
  QComboBox* time_;
  QComboBox* timeUnit_;
  QDoubleSpinBox* rate_;  ///< in place of the unit, where there is no time [Hz]
  QStackedWidget* unitOrRate_;
  QComboBox* travel_;
  QDoubleSpinBox* openTravel_;
  QDoubleSpinBox* closedTravel_;
  QDoubleSpinBox* zeroForce_;  ///< value of the cell without load
  QComboBox* force_;
  QComboBox* forceUnit_;
};

}  // namespace study::gui
