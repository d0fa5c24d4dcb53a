#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <QVector3D>

#include "haptics/engine/bone_models.h"
#include "haptics/reaming/bone/sphere_field.h"
#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// What the colours of the spheres show.
enum class SphereColours {
  Neutral,  ///< bone without information: the participant's view
  Density,  ///< the density
  Removal,  ///< the share that the reamer has removed
};

/// A sphere to draw. A radius of 0 means none.
struct SphereInstance {
  float x = 0.0F;  ///< [mm]
  float y = 0.0F;
  float z = 0.0F;
  float radius = 0.0F;  ///< [mm]
  Tint tint;
};

/// The visible spheres of a bone: those at its surface and those that the reamer has uncovered. All
/// others are surrounded by neighbours and are not drawn.
///
/// The cloud records which instances have changed, so that a renderer uploads only these.
class SphereCloud {
 public:
  struct Options {
    QVector3D eye{0.0F, -100.0F, -60.0F};  ///< the eye's position in the bone's frame [mm]
    bool isHalved = true;  ///< only the half with y ≥ 0: a section through the acetabulum
    SphereColours colours = SphereColours::Neutral;
  };

  /// @param field  the bone; changes refer to its slots.
  SphereCloud(const haptics::reaming::SphereField& field, const Options& options);

  /// Applies a change of one sphere, or a reset of all.
  void apply(const haptics::engine::SphereChange& change);

  /// The changes since the beginning, one for each changed sphere. A second cloud of the same bone
  /// that applies them looks the same.
  std::vector<haptics::engine::SphereChange> changesSoFar() const;

  const std::vector<SphereInstance>& instances() const noexcept { return instances_; }
  std::size_t shown() const noexcept { return instances_.size() - free_.size(); }

  /// Takes a contiguous range of instances that starts at index @p first.
  using Upload = std::function<void(std::size_t first, std::span<const SphereInstance> stretch)>;
  /// Passes the instances that changed since the last call to @p upload, range by range. The first
  /// call passes all.
  /// @return the number of instances passed.
  std::size_t uploadChanges(const Upload& upload);

  /// Makes the next uploadChanges() pass all instances, for a new renderer.
  void forgetUploads() noexcept { isAllNew_ = true; }

 private:
  struct Grid {
    QVector3D low;
    float cell = 1.0F;  ///< [mm]
    int nx = 1, ny = 1, nz = 1;
    std::size_t size() const noexcept;
    std::size_t of(const SphereInstance& sphere) const noexcept;
    std::array<std::size_t, 3> placeOf(std::size_t index) const noexcept;
  };
  struct Slot {
    SphereInstance sphere;
    float initialRadius = 0.0F;  ///< initial radius [mm]
    std::uint32_t cell = 0;      ///< index in the grid
    std::int32_t instance = -1;  ///< −1: not drawn
    Tint tint;                   ///< initial colour
  };

  void readSlots(const haptics::reaming::SphereField& field);
  void layGrid();
  void paintSlots(const haptics::reaming::SphereField& field);
  void begin();
  bool isKept(const SphereInstance& sphere) const noexcept;
  bool isVisibleFromEye(std::size_t cell) const;
  template <typename Visit>
  void forEachNeighbour(std::size_t cell, Visit visit) const;
  bool isInFrontOfSection(std::size_t cell) const noexcept;
  void uncover(std::size_t cell);
  void uncoverNeighbours(std::size_t cell);
  float emptinessOf(std::size_t cell) const noexcept;
  float opennessOf(std::size_t cell) const;
  void lightNeighbours(std::size_t cell, float before);
  void show(std::uint32_t slot);
  void hide(std::uint32_t slot);
  void markChanged(std::size_t instance);

  Options options_;
  Grid grid_;
  std::vector<Slot> slots_;
  std::vector<SphereInstance> initial_;            ///< the initial state of all slots
  std::vector<std::vector<std::uint32_t>> cells_;  ///< slots that are or were in each cell
  std::vector<std::uint32_t> counts_;              ///< number of spheres in each cell now
  std::vector<float> filled_;                      ///< cubed radii in each cell now [mm³]
  float fullCell_ = 1.0F;                          ///< mean of filled_ at the beginning [mm³]
  std::vector<char> isUncovered_;                  ///< whether a cell's spheres are drawn
  std::vector<SphereInstance> instances_;
  std::vector<std::uint32_t> free_;  ///< unused instances
  std::vector<std::uint32_t> changed_;
  bool isAllNew_ = true;
};

}  // namespace study::gui::scene
