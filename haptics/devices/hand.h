#pragma once

namespace haptics::devices {

/// A hand on a simulated tool.
class Hand {
 public:
  virtual ~Hand() = default;
  Hand() = default;
  Hand(const Hand&) = delete;
  Hand& operator=(const Hand&) = delete;

  /// How hard it pushes [N] on a tool at @p travel with @p velocity, @p dt [s] after the last time.
  virtual double push(double travel, double velocity, double dt) noexcept = 0;
};

}  // namespace haptics::devices
