#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "models/floor_plan.h"

namespace enfilade {

/// One side of a stretch of wall between two junctions.
struct HalfWall {
  std::size_t from = 0, to = 0;  ///< junctions
  std::size_t wall = 0;          ///< index in PlanStorey::walls
  std::size_t face = 0;          ///< the face on its left
  std::size_t twin = 0;          ///< the half that runs the other way
};

/// The areas that walls' centre lines cut the plane into.
struct PlanarFaces {
  std::vector<glm::dvec2> junctions;
  std::vector<HalfWall> halves;
  std::vector<std::vector<std::size_t>> faces;  ///< half walls in order, the face on their left

  std::vector<glm::dvec2> polygon(std::size_t face) const;
  glm::dvec2 start(std::size_t half) const { return junctions[halves[half].from]; }
  glm::dvec2 end(std::size_t half) const { return junctions[halves[half].to]; }
  glm::dvec2 direction(std::size_t half) const { return glm::normalize(end(half) - start(half)); }
};

/// Splits the walls at every crossing and junction and traces the faces.  Exactly one face, the
/// outside, has negative area.  Throws Error (kBadInput): walls that end in the open, lie on one
/// another, or do not hang together; over 512 of them, or over 2048 places where they meet.
PlanarFaces tracePlanarFaces(const std::vector<PlanWall>& walls, const std::string& subject);

}  // namespace enfilade
