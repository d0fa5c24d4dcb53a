#pragma once

#include <vector>

#include <QPointF>
#include <QWidget>

#include "haptics/devices/device.h"
#include "haptics/engine/force_engine.h"
#include "haptics/engine/sample_ring.h"

class QCustomPlot;
class QCPCurve;

namespace study::gui {

/// Plots force over travel, one curve for each of the last strokes of a running trial. Unlike a
/// plot over time it does not depend on the hand's speed. The last complete stroke and the current
/// one have the colour of forces; older ones are fainter.
class TravelPlot final : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kStrokes = 6;  ///< the largest number of strokes that are shown

  explicit TravelPlot(QWidget* parent = nullptr);

  /// Clears the plot for a trial on @p device.
  void begin(const haptics::devices::DeviceKind& device);
  void add(const haptics::engine::TickSample& sample);
  /// Draws the samples that were added.
  void refresh();

  /// The points of each shown stroke, the oldest first: x is the travel in the unit of
  /// travelScaleOf(), y the force [N].
  std::vector<std::vector<QPointF>> strokes() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void beginStroke();
  void applyThemeColours();

  QCustomPlot* plot_;
  std::vector<QCPCurve*> curves_;  ///< the oldest first
  haptics::engine::CutDetector detector_;
  double scale_ = 1.0;            ///< factor for travel
  std::int64_t sampleCount_ = 0;  ///< number of samples received; some are drawn
};

}  // namespace study::gui
