#pragma once

#include <array>
#include <vector>

#include <QPointF>
#include <QWidget>

#include "haptics/devices/device.h"
#include "haptics/engine/sample_ring.h"

class QCPAxisRect;
class QCustomPlot;

namespace study::gui {

/// Plots force and, if the device's scenes have one, the torque about the tool's axis, and below
/// them the travel, over the last ten seconds of a running trial; over four at its start, so that
/// the first strokes are not a narrow line at the edge.
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

  explicit LivePlot(QWidget* parent = nullptr);

  /// Clears the plot for a trial on @p device with ticks at @p rate [Hz].
  void begin(const haptics::devices::DeviceKind& device, double rate);
  void add(const haptics::engine::TickSample& sample);
  /// Draws the samples that were added.
  void refresh();

  /// The points of a channel (0 force [N], 1 travel, 2 torque [N·m]): x is the time [s], y the
  /// value; travel is in the unit of travelScaleOf().
  std::vector<QPointF> channel(int index) const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// The minimum and maximum of a channel within one slice of time.
  struct Slice {
    double least = 0.0, largest = 0.0;
    double leastAt = 0.0, largestAt = 0.0;  ///< [s]
    bool isEmpty = true;

    void add(double time, double value);
  };

  void stack(QCPAxisRect& below);
  void showTime(double from, double to);
  void endSlice();
  void applyThemeColours();

  QCustomPlot* plot_;
  double scale_ = 1.0;  ///< factor for travel
  std::array<Slice, 3> slices_;
  double period_ = 0.001;   ///< [s]
  std::int64_t slice_ = 0;  ///< index, counted from the start
  double lastTime_ = 0.0;   ///< [s]
};

}  // namespace study::gui
