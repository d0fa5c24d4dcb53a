#pragma once

#include <array>
#include <vector>

#include <QPointF>
#include <QWidget>

#include "haptics/devices/device.h"
#include "haptics/engine/sample_ring.h"

class QCustomPlot;

namespace study::gui {

/// Force, position and velocity over the last ten seconds, as they happen.
///
/// Every hundredth of a second is drawn as the least and the largest of its ticks, in the order in
/// which they came: no peak is lost, and a picture costs a fifth of one with every tick. One-pixel
/// pens, because a wider one makes every picture many times dearer.
class LivePlot final : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kShown = 10.0;  ///< [s]
  static constexpr double kSlice = 0.01;  ///< [s]

  explicit LivePlot(QWidget* parent = nullptr);

  /// A new trial begins on such a device, of ticks at @p rate [Hz].
  void begin(const haptics::devices::DeviceKind& device, double rate);
  void add(const haptics::engine::TickSample& sample);
  /// Draws what was added.
  void refresh();

  /// What a channel (0 force, 1 travel, 2 velocity) shows: x the time [s], y the value in the unit
  /// of travelScaleOf().
  std::vector<QPointF> channel(int index) const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// The least and the largest value of a slice of time.
  struct Slice {
    double least = 0.0, largest = 0.0;
    double leastAt = 0.0, largestAt = 0.0;  ///< [s]
    bool isEmpty = true;

    void add(double time, double value);
  };

  void endSlice();
  void paintAsTheTheme();

  QCustomPlot* plot_;
  double scale_ = 1.0;  ///< of travel and velocity
  std::array<Slice, 3> slices_;
  double period_ = 0.001;   ///< [s]
  std::int64_t slice_ = 0;  ///< since the start
  double last_ = 0.0;       ///< [s]
};

}  // namespace study::gui
