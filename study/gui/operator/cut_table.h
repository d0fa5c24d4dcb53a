#pragma once

#include <optional>

#include <QTableWidget>

#include "haptics/engine/force_engine.h"
#include "study/gui/operator/travel_scale.h"

namespace study::gui {

/// The strokes of a running trial: cuts of a punch with their landmarks, or strokes of a reamer
/// with depth and time. Each landmark of a cut appears as soon as it is detected, and its force and
/// travel once the cut is complete.
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

  haptics::engine::CutDetector detector_;
  double rate_ = 1000.0;
  TravelScale travel_;
  int cut_ = 0;
  std::optional<double> contact_;  ///< of the current cut, since the trial began [s]
};

}  // namespace study::gui
