#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "portals/house.h"
#include "scene/building.h"

namespace enfilade {

/// Builds small buildings of boxes for tests.
class TestBuilding {
 public:
  TestBuilding() {
    building.name = "test";
    building.materials.resize(2);
    building.materials[1].alpha_mode = AlphaMode::kBlend;
  }

  /// Turns all that is added from now on about the line along +Y through `pivot` [rad].
  void turn(float angle, const glm::vec3& pivot = glm::vec3(0)) {
    turned_ = glm::translate(glm::mat4(1), pivot);
    turned_ = glm::rotate(turned_, angle, glm::vec3(0, 1, 0));
    turned_ = glm::translate(turned_, -pivot);
  }

  /// A closed box; `glass` gives it blended material.
  void box(const glm::vec3& lo, const glm::vec3& hi, ObjectRole role = ObjectRole::kFixed,
           bool glass = false) {
    const auto corner = [&](unsigned i) {
      return glm::vec3(i & 1u ? hi.x : lo.x, i & 2u ? hi.y : lo.y, i & 4u ? hi.z : lo.z);
    };
    VertexArrays vertices;
    for (unsigned i = 0; i < 8; ++i) vertices.positions.push_back(corner(i));
    vertices.normals.assign(8, glm::vec3(0, 1, 0));
    add(std::move(vertices), {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                              2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6},
        role, glass);
  }

  /// One triangle.
  void triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    VertexArrays vertices;
    vertices.positions = {a, b, c};
    vertices.normals.assign(3, glm::vec3(0, 1, 0));
    add(std::move(vertices), {0, 1, 2}, ObjectRole::kFixed, false);
  }

  /// A hole in a wall, along the wall and in height [m].
  struct Hole {
    float from, to, bottom, top;
  };

  /// A wall from y0 to y1 along x (or z) between `from` and `to`, `at` in the other direction,
  /// with holes in order of their place, which do not overlap.
  void wall(bool along_x, float at, float from, float to, float y0, float y1,
            const std::vector<Hole>& holes = {}, float thickness = 0.2f) {
    const auto piece = [&](float a, float b, float bottom, float top) {
      if (b - a < 1e-4f || top - bottom < 1e-4f) return;
      const float lo = at - thickness / 2, hi = at + thickness / 2;
      if (along_x) {
        box({a, bottom, lo}, {b, top, hi});
      } else {
        box({lo, bottom, a}, {hi, top, b});
      }
    };
    float done = from;
    for (const Hole& hole : holes) {
      piece(done, hole.from, y0, y1);
      piece(hole.from, hole.to, y0, hole.bottom);
      piece(hole.from, hole.to, hole.top, y1);
      done = hole.to;
    }
    piece(done, to, y0, y1);
  }

  /// A slab whose top lies at `top`.
  void slab(float x0, float z0, float x1, float z1, float top, float thickness = 0.2f) {
    box({x0, top - thickness, z0}, {x1, top, z1});
  }

  /// Two rooms of 4 × 3 × 4 m side by side along x, from the origin, walls 0.2 m thick and no way
  /// out: holes in the wall between them at x = 4, and in the one at x = 8.
  void twoRooms(const std::vector<Hole>& between, const std::vector<Hole>& outer = {}) {
    slab(-0.2f, -0.2f, 8.2f, 4.2f, 0.0f);
    slab(-0.2f, -0.2f, 8.2f, 4.2f, 3.2f);
    wall(true, 0, 0, 8, 0, 3);
    wall(true, 4, 0, 8, 0, 3);
    wall(false, 0, 0, 4, 0, 3);
    wall(false, 4, 0, 4, 0, 3, between);
    wall(false, 8, 0, 4, 0, 3, outer);
  }

  Building building;
  std::vector<ObjectRole> roles;

 private:
  void add(VertexArrays vertices, std::vector<std::uint32_t> indices, ObjectRole role, bool glass) {
    const auto n = static_cast<std::uint32_t>(building.objects.size());
    Mesh mesh;
    mesh.name = "mesh-" + std::to_string(n);
    mesh.vertices = n;
    mesh.material = glass ? 1 : 0;
    mesh.indices = std::move(indices);
    for (const glm::vec3& p : vertices.positions) mesh.bounds.extend(p);
    building.vertex_arrays.push_back(std::move(vertices));
    building.meshes.push_back(std::move(mesh));
    Node node;
    node.name = "node-" + std::to_string(n);
    node.world_from_node = turned_;
    building.nodes.push_back(node);
    building.objects.push_back({n, n});
    roles.push_back(role);
  }

  glm::mat4 turned_{1};
};

}  // namespace enfilade
