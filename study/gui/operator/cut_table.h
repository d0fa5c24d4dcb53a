#pragma once

#include <optional>

#include <QTableWidget>

#include "haptics/engine/force_engine.h"
#include "study/gui/operator/travel_scale.h"

namespace study::gui {

/// The complete strokes of a running trial: cuts of a punch with force and travel at each landmark,
/// or strokes of a reamer with depth and time.
class CutTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit CutTable(QWidget* parent = nullptr);

  /// Clears the table for a trial on @p device with ticks at @p rate [Hz].
  void begin(const haptics::devices::DeviceKind& device, double rate);
  void add(const haptics::engine::TickSample& sample);

 private:
  void writeHeads(bool isCut);
  void write(int column, const QString& words);
  void write(int column, const haptics::engine::CutDetector::Landmark& landmark);

  QStringList titles_;  ///< of the landmarks, one for each pair of columns
  haptics::engine::CutDetector detector_;
  double rate_ = 1000.0;
  TravelScale travel_;
  int cut_ = 0;
  std::optional<double> contact_;  ///< of the current cut, since the trial began [s]
};

}  // namespace study::gui
