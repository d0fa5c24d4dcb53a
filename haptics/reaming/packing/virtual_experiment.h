#pragma once

#include <string>
#include <vector>

#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/packing/packed_bone.h"

namespace haptics::reaming {

/// The testing machine of the paper: it drives the reamer in at a feed and stops at a force or a
/// depth (reaming paper, "Experimental setup").
struct ExperimentOptions {
  double feed = 0.03e-3;    ///< [m/s]
  double step = 4e-6;       ///< of the reamer between two samples [m]
  double mostDepth = 0.02;  ///< [m]
  double mostForce = 800;   ///< [N]; a dynamic test has no such limit
};

/// What the machine would have written.
struct ExperimentResult {
  std::vector<double> depth;  ///< of the tool [m], rising
  std::vector<double> force;  ///< [N]
  double removedShare = 0.0;  ///< of the bone's mass
  std::string stop;           ///< why it ended, for people
};

/// Reams @p bone with the densities of hardness @p h, taking away what it goes through.
ExperimentResult ream(const PackedBone& bone, double h, const ExperimentOptions& options = {});

/// How far @p result is from the force @p wanted at each of @p depths: |felt − wanted| / |wanted|
/// over those that were reached.
double errorOf(
    const ExperimentResult& result,
    const std::vector<double>& depths,
    const std::vector<double>& wanted);

}  // namespace haptics::reaming
