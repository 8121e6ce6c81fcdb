#pragma once

#include <span>
#include <vector>

#include "preprocess/cut_cells.h"
#include "preprocess/patches.h"
#include "preprocess/share_geometry.h"
#include "render/ray_caster.h"
#include "visibility/portal_walk.h"

namespace enfilade {

/// The last part of a sight line that left its cell by no portal but through a crack that the
/// voxels do not know of: what it met lies beside no voxel of that cell.
struct CrackLine {
  PatchCells::Claim claim;     ///< what it met, and the cell that it left
  glm::vec3 start{0}, end{0};  ///< [m] where it came into the cell, and what it met
  float solid_from = 0;        ///< [m] from `start`: where it was last in the cell's voxels
  float solid_to = 0;          ///< [m] from `start`: where it came out into free space, or its end
};

/// What sight lines meet.
struct Sighted {
  std::vector<PatchCells::Claim> claims;
  std::vector<CrackLine> cracks;
  std::vector<PortalCrossing> crossings;  ///< kept for its memory
};

/// The cracks of all parts, in order.
std::vector<CrackLine> cracksOf(std::span<const Sighted> parts);
/// Adds the claims of all parts; `claims` is sorted and united afterwards.
void addClaims(std::span<const Sighted> parts, PatchCells& claims);

/// Follows sight lines through a building's cells.  Keeps references to all that it is given; for
/// several threads at once.
class SightClaims {
 public:
  SightClaims(const Building& building, const RayCaster& rays, const PortalWalker& walker,
              const Patches& patches, const CutCells& cells)
      : building_(building),
        rays_(rays),
        walker_(walker),
        patches_(patches),
        grid_(cells.grid),
        labels_(cells.labels) {}

  /// Appends what a line from `origin` in cell `start` meets, panes of glass on the way too.
  void follow(CellId start, const glm::vec3& origin, const glm::vec3& direction,
              Sighted& out) const;

  /// The label of the voxel at `p`; the exterior's outside the grid.
  CellGrid::Label labelAt(const glm::vec3& p) const noexcept { return label(grid_.voxelOf(p)); }

  float voxel() const noexcept { return grid_.voxel(); }  ///< edge [m]

 private:
  CellGrid::Label label(const glm::ivec3& v) const noexcept;
  bool liesBeside(const glm::vec3& p, CellId cell) const noexcept;
  CrackLine crackLine(const PatchCells::Claim& claim, const glm::vec3& start,
                      const glm::vec3& end) const noexcept;

  const Building& building_;
  const RayCaster& rays_;
  const PortalWalker& walker_;
  const Patches& patches_;
  const CellGrid& grid_;
  const std::vector<CellGrid::Label>& labels_;
};

}  // namespace enfilade
