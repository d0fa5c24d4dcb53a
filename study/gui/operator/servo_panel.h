#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "haptics/devices/device.h"
#include "study/gui/session/servo_health.h"

namespace study::gui {

/// Shows how punctually a trial is rendered: one line that says whether the timing is good
/// and whether the force reached its limit, and on demand the rate, the lateness of ticks, how
/// often the force limiter intervened, and the energy of the contact.
class ServoPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit ServoPanel(QWidget* parent = nullptr);

  /// Clears the panel for a trial on @p device with ticks at @p rate [Hz].
  void begin(const haptics::devices::DeviceKind& device, double rate);
  void add(const haptics::engine::TickSample& sample) { health_.add(sample); }
  /// Sets whether the loop has real-time priority.
  void setPriority(bool isRealtime) { isRealtime_ = isRealtime; }
  /// Shows what tells how large the force is, too, or leaves it out.
  void showForces(bool areShown);
  /// Shows the samples that were added.
  void refresh();

  const ServoHealth& health() const noexcept { return health_; }

 private:
  class Bars;
  void showTimingStatus();
  void showLimits();

  ServoHealth health_;
  QString energyUnit_;
  double nominalRate_ = 0.0;
  std::uint64_t ticksBefore_ = 0;
  double rate_ = 0.0;  ///< over the last second [Hz]
  QElapsedTimer sinceRate_;
  bool isRealtime_ = false;
  bool areForcesShown_ = true;
  QLabel* timingLabel_;
  QLabel* limitLabel_;  ///< what is not about timing: forces at their limit, leaps of the position
  QPushButton* details_;
  QWidget* more_;  ///< the details
  QLabel* words_;
  Bars* bars_;
};

}  // namespace study::gui
