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

/// A simulated scene in a window: asks for the newest that is known just before it draws, again and
/// again, and counts its frames while a trial runs. Takes no mouse and no key.
class SimulationView final : public QWidget {
  Q_OBJECT

 public:
  enum class Pace {
    Display,  ///< as often as the display; on a processor half as often, so that the hand is served
    Unbound,  ///< as often as it goes, to be measured
  };

  SimulationView(
      std::unique_ptr<SimulatedScene> scene,
      Graphics graphics,
      Pace pace = Pace::Display,
      QWidget* parent = nullptr);

  /// What is known now, asked for before each picture.
  void follow(std::function<Look()> look) { look_ = std::move(look); }

  /// How the frames were that the present trial, or the last one, was shown in.
  ViewReport report() const;

  const Renderer& renderer() const noexcept { return *graphics_.renderer; }
  /// For the person at the desk; empty where a graphics card draws.
  const QString& remark() const noexcept { return graphics_.remark; }
  SimulatedScene& scene() noexcept { return *scene_; }

  QSize sizeHint() const override { return {960, 600}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void beginCounting();
  std::int64_t period() const;
  QSize pictureSize() const;
  void drawNext();
  void noteShown();

  std::unique_ptr<SimulatedScene> scene_;
  Graphics graphics_;
  Pace pace_;
  std::function<Look()> look_;
  QTimer next_;
  QElapsedTimer sinceLast_;
  std::optional<FrameStatistics> statistics_;
  std::int64_t due_ = 0;         ///< of the next picture [ns on CLOCK_MONOTONIC]
  std::optional<Look> painted_;  ///< what the picture shows that is on its way to the display
  std::int64_t lostChanges_ = 0;
  bool wasRunning_ = false;
};

}  // namespace study::gui::scene
