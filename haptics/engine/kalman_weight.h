#pragma once

#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

/// How much the interpolated force weighs in what a filter settles to, from 0 (the finite elements
/// alone) to 1 (the recording alone), for a hand that moves 0.02 travel units a step; the mean of
/// two steps where both forces take turns. Smoothing changes nothing of it.
///
/// @param spec  sound.
double interpolationWeight(const KalmanSpec& spec) noexcept;

}  // namespace haptics::engine
