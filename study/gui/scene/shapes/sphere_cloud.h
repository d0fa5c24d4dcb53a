#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <QVector3D>

#include "haptics/engine/bone_view.h"
#include "haptics/reaming/bone/sphere_field.h"
#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// What the colour of a sphere says.
enum class SphereColours {
  Neutral,  ///< bone, and nothing else: what participants see
  Density,  ///< how hard it is
  Removal,  ///< how much of it the reamer has taken
};

/// A sphere as it is drawn. A radius of 0: none.
struct SphereInstance {
  float x = 0.0F;  ///< [mm]
  float y = 0.0F;
  float z = 0.0F;
  float radius = 0.0F;  ///< [mm]
  Tint tint;
};

/// The spheres of a bone that can be seen: those at its surface, and what the reamer lays bare. All
/// others have neighbours all round, and are not drawn.
///
/// Tells which of them have changed, so that only these are handed on to whoever draws them.
class SphereCloud {
 public:
  struct Options {
    QVector3D eye{0.0F, -100.0F, -60.0F};  ///< from where it is looked at, in the bone's frame [mm]
    bool isHalved = true;                  ///< only the half with y > 0: a section through the cup
    SphereColours colours = SphereColours::Neutral;
  };

  /// @param field  whose slots the changes will name.
  SphereCloud(const haptics::reaming::SphereField& field, const Options& options);

  /// Takes over what has happened to a sphere, or that all are whole again.
  void apply(const haptics::engine::SphereChange& change);

  /// What has become of the spheres since the beginning, one change for each that is not as it was:
  /// another cloud of the same bone that applies them looks the same.
  std::vector<haptics::engine::SphereChange> changesSoFar() const;

  const std::vector<SphereInstance>& instances() const noexcept { return instances_; }
  std::size_t shown() const noexcept { return instances_.size() - free_.size(); }

  /// Hands over what has changed since it was last asked, in stretches of instances from @p first
  /// on, and forgets it. The first time that is everything.
  /// @return how many instances.
  using Upload = std::function<void(std::size_t first, std::span<const SphereInstance> stretch)>;
  std::size_t uploadChanges(const Upload& upload);

  /// So that the next uploadChanges() hands over everything: for a new reader.
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
    float whole = 0.0F;          ///< radius at the beginning [mm]
    std::uint32_t cell = 0;      ///< of the grid
    std::int32_t instance = -1;  ///< -1: not drawn
    Tint tint;                   ///< at the beginning
  };

  void readSlots(const haptics::reaming::SphereField& field);
  void layGrid();
  void paintSlots(const haptics::reaming::SphereField& field);
  void begin();
  bool isKept(const SphereInstance& sphere) const noexcept;
  bool isOpen(std::size_t cell) const;
  template <typename Visit>
  void eachNeighbour(std::size_t cell, Visit visit) const;
  bool isBeforeTheSection(std::size_t cell) const noexcept;
  void bare(std::size_t cell);
  void bareDeeper(std::size_t cell);
  void show(std::uint32_t slot);
  void hide(std::uint32_t slot);
  void touch(std::size_t instance);

  Options options_;
  Grid grid_;
  std::vector<Slot> slots_;
  std::vector<SphereInstance> whole_;              ///< all slots, as they were at the beginning
  std::vector<std::vector<std::uint32_t>> cells_;  ///< slots that are, or were, in each cell
  std::vector<std::uint32_t> held_;                ///< spheres in each cell now
  std::vector<char> isBare_;                       ///< cells whose spheres are drawn
  std::vector<SphereInstance> instances_;
  std::vector<std::uint32_t> free_;  ///< instances that nobody needs
  std::vector<std::uint32_t> changed_;
  bool isAllNew_ = true;
};

}  // namespace study::gui::scene
