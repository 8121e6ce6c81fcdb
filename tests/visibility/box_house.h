#pragma once

#include <array>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "portals/cell_graph.h"

namespace enfilade::testing {

/// A random block of box rooms between axis-parallel planes, walls without thickness, openings cut
/// in them; some walls are missing (so that cells are not convex), some rooms are courts that
/// belong to the exterior.  What can be seen in it is known exactly, by crossing the planes one by
/// one.
class BoxHouse {
 public:
  struct Options {
    glm::ivec3 rooms{4, 2, 4};
    double door_chance = 0.5;     ///< of a wall between two rooms, and of an outer wall
    double missing_chance = 0.2;  ///< of a wall between two rooms
    double court_chance = 0.1;    ///< of a room
  };

  BoxHouse(unsigned seed, const Options& options);

  const CellGraph& graph() const { return graph_; }
  CellId cellAt(const glm::dvec3& p) const;
  /// Whether nothing but openings lies between two points; a point that lies in a wall sees
  /// nothing.
  bool sees(const glm::dvec3& a, const glm::dvec3& b) const;
  glm::dvec3 least() const { return {planes_[0].front(), planes_[1].front(), planes_[2].front()}; }
  glm::dvec3 most() const { return {planes_[0].back(), planes_[1].back(), planes_[2].back()}; }
  /// Every opening, those too that join a cell with itself.
  const std::vector<std::array<glm::dvec3, 2>>& openings() const { return openings_; }

 private:
  struct Wall {
    bool missing = false;
    glm::dvec3 least{0};  // of its opening, if least < most in the wall's two axes
    glm::dvec3 most{0};
    bool opening = false;
  };

  glm::ivec3 roomAt(const glm::dvec3& p) const;  // −1 or the count of rooms: outside
  bool isInside(const glm::ivec3& room) const;
  CellId cellOf(const glm::ivec3& room) const;
  std::size_t roomIndex(const glm::ivec3& room) const;
  Wall& wall(int axis, const glm::ivec3& below);  // between `below` and the next room along `axis`
  const Wall& wall(int axis, const glm::ivec3& below) const;
  bool passes(int axis, int plane, const glm::dvec3& at) const;
  bool liesWhereWallsMeet(const glm::dvec3& p) const;
  void cutWalls(std::mt19937& random, const Options& options);
  void nameCells(const std::vector<bool>& court);
  void makePortals();

  std::array<std::vector<double>, 3> planes_;
  glm::ivec3 rooms_;
  std::array<std::vector<Wall>, 3> walls_;
  std::vector<CellId> cells_;  // of each room
  std::vector<std::array<glm::dvec3, 2>> openings_;
  CellGraph graph_;
};

/// A point in the house or up to `margin` [m] outside.
glm::vec3 randomPoint(std::mt19937& random, const BoxHouse& house, double margin);

/// A point in an opening, on its edge, in its corner, or off it within its plane; or as near to
/// such a point as makes trouble.
glm::vec3 pointAtAnOpening(std::mt19937& random, const BoxHouse& house);

}  // namespace enfilade::testing
