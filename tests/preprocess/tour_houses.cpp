#include "tour_houses.h"

#include <cmath>

namespace enfilade::testing {

namespace {

constexpr float kVoxel = 0.1f;
constexpr float kPassage = 0.3f;

Box boxOf(const glm::vec3& a, const glm::vec3& b) { return {glm::min(a, b), glm::max(a, b)}; }

int flatAxis(const glm::vec3& size) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (size[k] < size[axis]) axis = k;
  }
  return axis;
}

}  // namespace

HouseBuilder::HouseBuilder() {
  house_.info.model_name = "test";
  house_.graph.storeys.push_back({"ground", 0.0f});
  house_.graph.cells.emplace_back().name = "exterior";
  house_.building.materials.emplace_back();
  cells_.emplace_back();
}

void HouseBuilder::addMesh(const std::vector<glm::vec3>& positions,
                           const std::vector<std::uint32_t>& indices, ObjectRole role) {
  Building& building = house_.building;
  const auto number = static_cast<std::uint32_t>(building.objects.size());
  VertexArrays vertices;
  vertices.positions = positions;
  vertices.normals.assign(positions.size(), glm::vec3(0, 1, 0));
  building.vertex_arrays.push_back(vertices);
  Mesh mesh;
  mesh.vertices = number;
  mesh.indices = indices;
  for (const glm::vec3& p : positions) mesh.bounds.extend(p);
  building.meshes.push_back(mesh);
  building.nodes.emplace_back();
  building.objects.push_back({number, number});
  house_.object_roles.push_back(role);
}

void HouseBuilder::solid(const glm::vec3& a, const glm::vec3& b, ObjectRole role) {
  const Box box = boxOf(a, b);
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                         (i & 4) != 0 ? box.max.z : box.min.z);
  }
  addMesh(corners, {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5},
          role);
  if (role != ObjectRole::kDoor) solids_.push_back(box);
}

void HouseBuilder::triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  addMesh({a, b, c}, {0, 1, 2}, ObjectRole::kFixed);
}

CellId HouseBuilder::cell(const std::string& name, const glm::vec3& a, const glm::vec3& b) {
  cells_.push_back(boxOf(a, b));
  Cell& added = house_.graph.cells.emplace_back();
  added.name = name;
  added.bounds = cells_.back();
  return static_cast<CellId>(cells_.size() - 1);
}

void HouseBuilder::portal(CellId front, CellId back, PortalKind kind, const glm::vec3& least,
                          const glm::vec3& most) {
  const int axis = flatAxis(most - least);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  Portal portal;
  portal.front = front;
  portal.back = back;
  portal.kind = kind;
  portal.polygon = {least, least, most, most};
  portal.polygon[1][u] = most[u];
  portal.polygon[3] = least;
  portal.polygon[3][v] = most[v];
  portal.plane = planeOf(portal.polygon);
  house_.graph.portals.push_back(portal);
  Box passage{least, most};
  passage.min[axis] -= kPassage;
  passage.max[axis] += kPassage;
  passages_.push_back(passage);
}

void HouseBuilder::slabs(const glm::vec3& a, const glm::vec3& b) {
  solid({a.x, a.y - 0.2f, a.z}, {b.x, a.y, b.z});
  solid({a.x, b.y, a.z}, {b.x, b.y + 0.2f, b.z});
}

void HouseBuilder::wallWithHole(const glm::vec3& a, const glm::vec3& b, float hole_z0,
                                float hole_z1, float hole_y0, float hole_y1) {
  solid(a, {b.x, b.y, hole_z0});
  solid({a.x, a.y, hole_z1}, b);
  if (hole_y0 > a.y) solid({a.x, a.y, hole_z0}, {b.x, hole_y0, hole_z1});
  if (hole_y1 < b.y) solid({a.x, hole_y1, hole_z0}, {b.x, b.y, hole_z1});
}

CellGrid::Label HouseBuilder::labelAt(const glm::vec3& p) const {
  for (const Box& solid : solids_) {
    if (solid.contains(p)) return CellGrid::kSolidVoxel;
  }
  for (std::size_t i = 0; i < passages_.size(); ++i) {
    const Portal& portal = house_.graph.portals[i];
    if (!passages_[i].contains(p)) continue;
    const float side = portal.plane.signedDistance(p);
    if (std::abs(side) < kVoxel) return CellGrid::kCutVoxel;
    return static_cast<CellGrid::Label>(side > 0 ? portal.front : portal.back);
  }
  for (std::size_t c = 1; c < cells_.size(); ++c) {
    if (cells_[c].contains(p)) return static_cast<CellGrid::Label>(c);
  }
  return static_cast<CellGrid::Label>(kExterior);
}

House HouseBuilder::build() {
  const Box bounds = worldBounds(house_.building).grown(0.5f);
  const glm::ivec3 size = glm::ivec3(glm::ceil(bounds.size() / kVoxel));
  std::vector<CellGrid::Label> labels;
  for (int x = 0; x < size.x; ++x) {
    for (int z = 0; z < size.z; ++z) {
      for (int y = 0; y < size.y; ++y) {
        labels.push_back(labelAt(bounds.min + (glm::vec3(x, y, z) + 0.5f) * kVoxel));
      }
    }
  }
  house_.grid = CellGrid(bounds.min, kVoxel, size, labels);
  linkCells(house_.graph);
  return house_;
}

HouseBuilder twoRooms(float width, float head) {
  HouseBuilder b;
  b.slabs({-0.2f, 0, -0.2f}, {8.4f, 2.6f, 4.2f});
  b.solid({-0.2f, 0, -0.2f}, {0, 2.6f, 4.2f});
  b.solid({8.2f, 0, -0.2f}, {8.4f, 2.6f, 4.2f});
  b.solid({0, 0, -0.2f}, {8.2f, 2.6f, 0});
  b.solid({0, 0, 4}, {8.2f, 2.6f, 4.2f});
  b.wallWithHole({4, 0, 0}, {4.2f, 2.6f, 4}, 2 - 0.5f * width, 2 + 0.5f * width, 0, head);
  const CellId left = b.cell("left", {0, 0, 0}, {4, 2.6f, 4});
  const CellId right = b.cell("right", {4.2f, 0, 0}, {8.2f, 2.6f, 4});
  b.portal(right, left, PortalKind::kDoor, {4.1f, 0, 2 - 0.5f * width},
           {4.1f, head, 2 + 0.5f * width});
  return b;
}

}  // namespace enfilade::testing
