#include "haptics/engine/parametric_material.h"

namespace haptics::engine {

std::vector<MaterialNode> parametricMaterial() {
  return {
      {0.000, 0.0, 0.0},
      {0.001, 0.5, 4.0},
      {0.002, 2.0, 20.0},
      {0.003, 8.0, 90.0},
      {0.004, 20.0, 230.0},
      {0.005, 30.0, 330.0},  // the local peak: the subchondral lamella
      {0.006, 27.0, 300.0},
      {0.007, 24.0, 285.0},
      {0.009, 28.0, 360.0},
      {0.012, 38.0, 500.0},
      {0.016, 50.0, 660.0},
      {0.020, 60.0, 800.0},
  };
}

}  // namespace haptics::engine
