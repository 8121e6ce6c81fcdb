#pragma once

#include <string>
#include <vector>

#include "portals/house.h"
#include "scene/geometry.h"

namespace enfilade::testing {

/// Builds small houses by hand: solid boxes, cells as boxes of free space, portals as rectangles.
class HouseBuilder {
 public:
  HouseBuilder();

  /// A solid box, by two opposite corners [m].
  void solid(const glm::vec3& a, const glm::vec3& b, ObjectRole role = ObjectRole::kFixed);
  /// A triangle that no box makes.
  void triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
  /// A room of free space; its number.
  CellId cell(const std::string& name, const glm::vec3& a, const glm::vec3& b);
  /// An upright or level rectangle with `least` and `most` as its corners, flat along one axis.
  /// `front` is on the positive side of that axis.  Free space for 0.3 m on both sides.
  void portal(CellId front, CellId back, PortalKind kind, const glm::vec3& least,
              const glm::vec3& most);
  /// Floor slab, ceiling slab and nothing else.
  void slabs(const glm::vec3& a, const glm::vec3& b);
  /// A wall along z (x0…x1 thick) with one hole, from y0 to y1.
  void wallWithHole(const glm::vec3& a, const glm::vec3& b, float hole_z0, float hole_z1,
                    float hole_y0, float hole_y1);

  House build();

 private:
  CellGrid::Label labelAt(const glm::vec3& p) const;
  void addMesh(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices,
               ObjectRole role);

  House house_;
  std::vector<Box> solids_;
  std::vector<Box> cells_;
  std::vector<Box> passages_;
};

/// Two rooms of 4 × 4 × 2.6 m side by side along x with a wall between, x = 4…4.2, and a doorway
/// `width` wide and `head` high in its middle. Walls all around, no way out.
HouseBuilder twoRooms(float width, float head = 2.1f);

}  // namespace enfilade::testing
