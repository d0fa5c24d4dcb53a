#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "study/gui/scene/frame_statistics.h"
#include "study/gui/scene/renderer.h"
#include "study/gui/scene/simulated_scene.h"

namespace study::gui::scene {

/// A widget that shows a simulated scene. It reads the latest state before each picture and counts
/// the frames of a running trial. It ignores mouse and keyboard.
class SimulationView final : public QWidget {
  Q_OBJECT

 public:
  enum class Pace {
    Display,  ///< the display's rate; half of it without a graphics card, to leave time for the
              ///< haptic loop
    Unbound,  ///< as fast as possible, for benchmarks
  };

  SimulationView(
      std::unique_ptr<SimulatedScene> scene,
      RendererWithRemark graphics,
      QWidget* parent = nullptr,
      Pace pace = Pace::Display);

  /// Sets the function that returns the current state; called before each picture.
  void setSnapshotSource(std::function<TrialSnapshot()> source) {
    snapshotSource_ = std::move(source);
  }

  /// The frame statistics of the running trial, or else of the last one.
  ViewReport report() const;
  double longestInterval() const { return statistics_->longest(); }  ///< of the same trial [ms]

  /// Size of the picture that is drawn [pixels], which is smaller than a large view: it is scaled
  /// up.
  QSize pictureSize() const;

  const Renderer& renderer() const noexcept { return *graphics_.renderer; }
  /// A message for the operator; empty if a graphics card draws.
  const QString& remark() const noexcept { return graphics_.remark; }
  SimulatedScene& scene() noexcept { return *scene_; }

  QSize sizeHint() const override { return {960, 600}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void beginCounting();
  std::int64_t period() const;
  void drawNext();
  void noteShown();

  std::unique_ptr<SimulatedScene> scene_;
  RendererWithRemark graphics_;
  Pace pace_;
  std::function<TrialSnapshot()> snapshotSource_;
  QTimer frameTimer_;
  QElapsedTimer sinceLast_;
  std::optional<FrameStatistics> statistics_;
  std::int64_t due_ = 0;  ///< time of the next picture [ns on CLOCK_MONOTONIC]
  std::optional<TrialSnapshot>
      paintedState_;  ///< state in the picture that is not on the display yet
  std::int64_t lostChanges_ = 0;
  bool wasRunning_ = false;
};

}  // namespace study::gui::scene
