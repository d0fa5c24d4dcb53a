#pragma once

namespace haptics::reaming {

/// How a bone that is cut answers.
struct BoneOptions {
  double coverage = 1.0;       ///< of the packing: areas are divided by it, (0, 1]
  double coupling = 50'000.0;  ///< between the device and the tool that the bone holds [N/m], > 0
  double cuttingDamping = 2000.0;  ///< what the force grows by with the feed [N·s/m], >= 0
  double friction = 0.1;           ///< of the tool on what it touches, >= 0
  double mostAdvance = 5e-5;       ///< in one step, through bone [m], > 0
  bool isGuided = false;           ///< held to a line along its axis, as by a testing machine
  bool isSpinning = true;          ///< forwards; teeth that stand still or go backwards do not cut
};

}  // namespace haptics::reaming
