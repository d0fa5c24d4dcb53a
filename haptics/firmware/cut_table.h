#pragma once

#include "haptics/models/interpolation.h"

namespace haptics::firmware {

/// The parametric cut, haptics::recordings::parametricCut(), at 33 points: travel in travel
/// units, force in N. A test holds it to its source.
inline constexpr int kCutPoints = 33;
inline constexpr models::CurveNode<float> kCut[kCutPoints]{
    {2.000000f, 0.000000f},  {2.281250f, 0.000000f},  {2.562500f, 0.000000f},
    {2.843750f, 0.000000f},  {3.125000f, 0.000000f},  {3.406250f, 0.000000f},
    {3.687500f, 0.000000f},  {3.968750f, 0.033668f},  {4.250000f, 0.212925f},
    {4.531250f, 0.524420f},  {4.812500f, 0.938683f},  {5.093750f, 1.426580f},
    {5.375000f, 1.957969f},  {5.656250f, 2.502203f},  {5.937500f, 3.029814f},
    {6.218750f, 3.511330f},  {6.500000f, 3.917281f},  {6.781250f, 4.214922f},
    {7.062500f, 4.376547f},  {7.343750f, 4.363470f},  {7.625000f, 4.155688f},
    {7.906250f, 3.858906f},  {8.187500f, 3.598431f},  {8.468750f, 3.488603f},
    {8.750000f, 3.436339f},  {9.031250f, 3.378219f},  {9.312500f, 3.320001f},
    {9.593750f, 3.267534f},  {9.875000f, 3.226866f},  {10.156250f, 3.203666f},
    {10.437500f, 3.307580f}, {10.718750f, 3.976676f}, {11.000000f, 5.000000f},
};

}  // namespace haptics::firmware
