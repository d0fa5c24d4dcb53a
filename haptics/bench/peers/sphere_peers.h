#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/reaming/bone/sphere_field.h"

namespace haptics::bench::peers {

/// Another way to find the spheres that a reamer's surface cuts; it adds up the same areas one by
/// one.
class SpherePeer {
 public:
  virtual ~SpherePeer() = default;
  virtual std::string name() const = 0;

  /// Σ a ρ [N].
  virtual double pressing(const reaming::Reamer& reamer) = 0;
};

/// nanoflann, a k-d tree of centres, where it was installed when this was built.
std::vector<std::unique_ptr<SpherePeer>> spherePeers(
    const reaming::Packing& packing, const std::vector<double>& densities);

}  // namespace haptics::bench::peers
