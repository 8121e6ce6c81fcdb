#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "portals/house.h"
#include "scene/building.h"

namespace enfilade {

/// What stands in a voxel, as bits.
inline constexpr std::uint8_t kVoxelSolid =
    1;  ///< a surface that hides what is behind it, or that one cannot walk through
inline constexpr std::uint8_t kVoxelDoor = 2;   ///< an openable door
inline constexpr std::uint8_t kVoxelGlass = 4;  ///< a window, or blended material

/// From a voxel to those that share a face with it.
inline constexpr std::array<glm::ivec3, 6> kVoxelSides{
    glm::ivec3{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}};

/// A dense grid of surface voxels around a building, with a margin of free voxels on every side.
struct VoxelGrid {
  glm::vec3 origin{0};  ///< least corner [m]
  float voxel = 0.1f;   ///< edge [m]
  glm::ivec3 size{0};
  std::vector<std::uint8_t> bits;  ///< index (x · size.z + z) · size.y + y

  std::size_t index(int x, int y, int z) const noexcept {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(size.z) +
            static_cast<std::size_t>(z)) *
               static_cast<std::size_t>(size.y) +
           static_cast<std::size_t>(y);
  }
  /// The voxel of an index.
  glm::ivec3 voxelAt(std::size_t i) const noexcept {
    const auto size_y = static_cast<std::size_t>(size.y);
    const auto size_z = static_cast<std::size_t>(size.z);
    return {static_cast<int>(i / size_y / size_z), static_cast<int>(i % size_y),
            static_cast<int>(i / size_y % size_z)};
  }
  bool contains(const glm::ivec3& v) const noexcept {
    return glm::all(glm::greaterThanEqual(v, glm::ivec3(0))) && glm::all(glm::lessThan(v, size));
  }
  glm::vec3 centerOf(const glm::ivec3& v) const noexcept {
    return origin + (glm::vec3(v) + 0.5f) * voxel;
  }
  glm::ivec3 voxelOf(const glm::vec3& p) const noexcept {
    return glm::ivec3(glm::floor((p - origin) / voxel));
  }
};

/// Every voxel that a triangle touches (conservative triangle–box test with an epsilon).  An
/// object's bit follows from its role; of a fixed object, blended material counts as glass.
/// `margin` [voxels] on every side. Throws Error (kBadInput) if the building is so large that the
/// grid would not fit in memory, naming a voxel size that would. Source: Akenine-Möller, Fast 3D
/// Triangle-Box Overlap Testing, 2001.
VoxelGrid voxelise(const Building& building, std::span<const ObjectRole> roles, float voxel,
                   int margin = 4);

}  // namespace enfilade
