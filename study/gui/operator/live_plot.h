#pragma once

#include <array>
#include <vector>

#include <QPointF>
#include <QWidget>

#include "haptics/devices/device.h"
#include "haptics/engine/sample_ring.h"

class QCustomPlot;

namespace study::gui {

/// Plots force, position, velocity and, if the device's scenes have one, the torque about the
/// tool's axis over the last ten seconds of a running trial; over four at its start, so that the
/// first strokes are not a narrow line at the edge. A narrow plot has no velocity, nor has one with
/// force and travel one above the other.
///
/// Each slice of 10 ms is drawn as its minimum and maximum, in the order in which they occurred. No
/// peak is lost, and drawing takes a fifth of the time of drawing every tick. Pens are one pixel
/// wide because wider pens are many times slower.
class LivePlot final : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kShown = 10.0;  ///< [s]
  static constexpr double kFirst = 4.0;   ///< at the start of a trial [s]
  static constexpr double kSlice = 0.01;  ///< [s]

  /// Whether force and travel share their place, or are one above the other with a heading each.
  enum class Arrangement { Shared, Stacked };

  explicit LivePlot(QWidget* parent = nullptr, Arrangement arrangement = Arrangement::Shared);

  /// Clears the plot for a trial on @p device with ticks at @p rate [Hz].
  void begin(const haptics::devices::DeviceKind& device, double rate);
  void add(const haptics::engine::TickSample& sample);
  /// Draws the samples that were added.
  void refresh();

  /// The points of a channel (0 force [N], 1 travel, 2 velocity, 3 torque [N·m]): x is the time
  /// [s], y the value; travel and velocity are in the unit of travelScaleOf().
  std::vector<QPointF> channel(int index) const;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// The minimum and maximum of a channel within one slice of time.
  struct Slice {
    double least = 0.0, largest = 0.0;
    double leastAt = 0.0, largestAt = 0.0;  ///< [s]
    bool isEmpty = true;

    void add(double time, double value);
  };

  void stack();
  void showTime(double from, double to);
  void endSlice();
  void applyThemeColours();

  QCustomPlot* plot_;
  Arrangement arrangement_;
  double scale_ = 1.0;  ///< factor for travel and velocity
  std::array<Slice, 4> slices_;
  double period_ = 0.001;   ///< [s]
  std::int64_t slice_ = 0;  ///< index, counted from the start
  double lastTime_ = 0.0;   ///< [s]
};

}  // namespace study::gui
