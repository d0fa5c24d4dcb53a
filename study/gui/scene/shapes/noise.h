#pragma once

#include <QVector3D>

namespace study::gui::scene {

/// Smooth noise at @p place, in [−1, 1]: it changes over about one unit. The same at each call.
float noiseAt(QVector3D place);

/// Noise with details: the sum of @p octaves noises, each half as wide and half as strong as the
/// one before, in [−1, 1].
float roughnessAt(QVector3D place, int octaves);

}  // namespace study::gui::scene
