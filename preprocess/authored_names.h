#pragma once

#include <string>
#include <vector>

#include "portals/cell_graph.h"
#include "preprocess/cell_proposal.h"
#include "preprocess/voxel_grid.h"
#include "scene/building.h"

namespace enfilade {

/// What a model's author said of its cells and portals, by names in the convention of Godot 3's
/// rooms and portals (`NAME-room`, `NAME-portal`, `NAME-bound`, each perhaps with a trailing
/// -NUMBER) or in `extras.enfilade`.
struct AuthoredNames {
  struct Room {
    std::string name;
    Box bounds;                       ///< of what belongs to it [m]
    std::vector<Plane> bound_planes;  ///< of its convex bound, inside ≥ 0; empty: `bounds` alone
    glm::vec3 position{0};            ///< where its node stands, the first of several [m]

    /// Whether a point of its bounds is the room's, by its planes.
    bool withinPlanes(const glm::vec3& p) const;
  };
  struct NamedPortal {
    Portal portal;         ///< polygon as seen from its room; front and back not yet known
    std::string from, to;  ///< rooms' names; `to` may be empty: by geometry
  };
  std::vector<Room> rooms;  ///< in order of their nodes, without the exterior
  std::vector<NamedPortal> portals;
  std::vector<std::string> warnings;

  bool empty() const noexcept { return rooms.empty(); }
};

/// Reads the names, and takes the marker meshes (portals and bounds) out of `building`, which are
/// not part of the picture.
AuthoredNames takeAuthoredNames(Building& building);

/// The author's portals, with their planes; front and back not yet known.
std::vector<Portal> authoredPortals(const AuthoredNames& names);

/// The cells and portals that the author named and no others, for cutCells().  Storeys from the
/// floors of the rooms.
CellProposal authoredCells(const AuthoredNames& names, const VoxelGrid& voxels);

}  // namespace enfilade
