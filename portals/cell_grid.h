#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "portals/cell_graph.h"

namespace enfilade {

/// Which cell owns each voxel of free space: a grid of labels, run-length coded along y.
/// A label is a CellId, kSolidVoxel, or kCutVoxel (free, but crossed by a portal: the portal's
/// plane decides). Outside the grid lies the exterior.
class CellGrid {
 public:
  using Label = std::uint16_t;
  static constexpr Label kSolidVoxel = 0xffff;
  static constexpr Label kCutVoxel = 0xfffe;

  struct Run {
    std::uint16_t end_y = 0;  ///< one past the run's last voxel
    Label label = kSolidVoxel;
    bool operator==(const Run&) const = default;
  };

  CellGrid() = default;
  /// `labels` is dense, index (x · size.z + z) · size.y + y.  Throws Error (kBadInput) unless sizes
  /// are 1…65535 and the voxel edge is positive.
  CellGrid(const glm::vec3& origin, float voxel, const glm::ivec3& size,
           std::span<const Label> labels);
  /// From runs as stored: `first` has size.x · size.z + 1 entries into `runs`.  Checked: throws
  /// Error (kBadInput).
  CellGrid(const glm::vec3& origin, float voxel, const glm::ivec3& size,
           std::vector<std::uint32_t> first, std::vector<Run> runs);

  const glm::vec3& origin() const noexcept { return origin_; }  ///< least corner [m]
  float voxel() const noexcept { return voxel_; }               ///< edge [m]
  const glm::ivec3& size() const noexcept { return size_; }
  std::span<const Run> column(int x, int z) const noexcept;
  std::span<const std::uint32_t> firstRuns() const noexcept { return first_; }
  std::span<const Run> runs() const noexcept { return runs_; }

  glm::ivec3 voxelOf(const glm::vec3& p) const noexcept;  ///< may lie outside the grid
  glm::vec3 centerOf(const glm::ivec3& v) const noexcept;
  Label labelAt(const glm::ivec3& v) const noexcept;  ///< kExterior outside the grid

 private:
  glm::vec3 origin_{0};
  float voxel_ = 0.1f;
  glm::ivec3 size_{0};
  std::vector<std::uint32_t> first_;
  std::vector<Run> runs_;
};

/// Where a point is.
struct CellLocation {
  CellId cell = kExterior;
  bool in_free_space =
      true;  ///< false: the point is inside something solid, and `cell` is the nearest
};

/// The cell at `p`.  In a voxel that a portal crosses, the side of the nearest portal's plane
/// decides, and which of the portal's two cells is labelled nearest there.  In something solid: the
/// cell of the nearest labelled voxel, one that is reached without passing a portal or its frame if
/// there is one about as near.
CellLocation locate(const CellGraph& graph, const CellGrid& grid, const glm::vec3& p);

}  // namespace enfilade
