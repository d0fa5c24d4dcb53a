#pragma once

#include <QTableWidget>

#include "haptics/engine/force_engine.h"
#include "study/gui/operator/travel_scale.h"

namespace study::gui {

/// The cuts of a trial as they happen: each landmark when it has become clear, with the force and
/// the travel of a cut that is complete.
class CutTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit CutTable(QWidget* parent = nullptr);

  /// A new trial begins on such a device, of ticks at @p rate [Hz].
  void begin(const haptics::devices::DeviceKind& device, double rate);
  void add(const haptics::engine::TickSample& sample);

 private:
  void write(int column, const QString& words);

  haptics::engine::CutDetector detector_;
  double rate_ = 1000.0;
  TravelScale travel_;
  int cut_ = 0;
};

}  // namespace study::gui
