#include "box_house.h"

#include <algorithm>
#include <functional>

namespace enfilade::testing {

namespace {

double uniform(std::mt19937& random, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(random);
}

}  // namespace

BoxHouse::BoxHouse(unsigned seed, const Options& options) : rooms_(options.rooms) {
  std::mt19937 random(seed);
  for (int axis = 0; axis < 3; ++axis) {
    double at = uniform(random, -5, 5);
    for (int i = 0; i <= rooms_[axis]; ++i) {
      // Exactly what single precision holds, as the graph's polygons have it.
      planes_[static_cast<std::size_t>(axis)].push_back(static_cast<float>(at));
      at += axis == 1 ? 2.5 : uniform(random, 1.5, 5);
    }
  }
  std::vector<bool> court(static_cast<std::size_t>(rooms_.x * rooms_.y * rooms_.z));
  for (std::size_t i = 0; i < court.size(); ++i) {
    court[i] = uniform(random, 0, 1) < options.court_chance;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const glm::ivec3 size = rooms_ + glm::ivec3(2);
    walls_[axis].resize(static_cast<std::size_t>(size.x * size.y * size.z));
  }
  cutWalls(random, options);
  nameCells(court);
  makePortals();
}

bool BoxHouse::isInside(const glm::ivec3& room) const {
  return glm::all(glm::greaterThanEqual(room, glm::ivec3(0))) &&
         glm::all(glm::lessThan(room, rooms_));
}

std::size_t BoxHouse::roomIndex(const glm::ivec3& room) const {
  return static_cast<std::size_t>((room.x * rooms_.y + room.y) * rooms_.z + room.z);
}

CellId BoxHouse::cellOf(const glm::ivec3& room) const {
  return isInside(room) ? cells_[roomIndex(room)] : kExterior;
}

BoxHouse::Wall& BoxHouse::wall(int axis, const glm::ivec3& below) {
  const glm::ivec3 size = rooms_ + glm::ivec3(2);
  const glm::ivec3 i = below + glm::ivec3(1);
  return walls_[static_cast<std::size_t>(axis)]
               [static_cast<std::size_t>((i.x * size.y + i.y) * size.z + i.z)];
}

const BoxHouse::Wall& BoxHouse::wall(int axis, const glm::ivec3& below) const {
  return const_cast<BoxHouse*>(this)->wall(axis, below);
}

glm::ivec3 BoxHouse::roomAt(const glm::dvec3& p) const {
  glm::ivec3 room;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& planes = planes_[static_cast<std::size_t>(axis)];
    room[axis] =
        static_cast<int>(std::upper_bound(planes.begin(), planes.end(), p[axis]) - planes.begin()) -
        1;
  }
  return room;
}

CellId BoxHouse::cellAt(const glm::dvec3& p) const { return cellOf(roomAt(p)); }

void BoxHouse::cutWalls(std::mt19937& random, const Options& options) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int x = -1; x < rooms_.x; ++x) {
      for (int y = -1; y < rooms_.y; ++y) {
        for (int z = -1; z < rooms_.z; ++z) {
          const glm::ivec3 below(x, y, z);
          glm::ivec3 above = below;
          ++above[axis];
          if (!isInside(below) && !isInside(above)) continue;
          Wall& w = wall(axis, below);
          const bool inner = isInside(below) && isInside(above);
          w.missing = inner && uniform(random, 0, 1) < options.missing_chance;
          w.opening = !w.missing && uniform(random, 0, 1) < options.door_chance;
          for (int other = 0; other < 3; ++other) {
            const auto& planes = planes_[static_cast<std::size_t>(other)];
            if (other == axis) {
              w.least[other] = w.most[other] = planes[static_cast<std::size_t>(above[axis])];
              continue;
            }
            const glm::ivec3 room = isInside(below) ? below : above;
            const double low = planes[static_cast<std::size_t>(room[other])];
            const double high = planes[static_cast<std::size_t>(room[other] + 1)];
            // Now and then an opening reaches the next wall, so that openings meet at an edge.
            const double a = uniform(random, 0, 1) < 0.2 ? 0 : uniform(random, 0.02, 0.6);
            const double b = uniform(random, 0, 1) < 0.2 ? 1 : uniform(random, a + 0.1, 0.98);
            w.least[other] = static_cast<float>(glm::mix(low, high, a));
            w.most[other] = static_cast<float>(glm::mix(low, high, b));
          }
        }
      }
    }
  }
}

void BoxHouse::nameCells(const std::vector<bool>& court) {
  // Rooms without a wall between them are one cell; the last set's id stands for the exterior.
  const std::size_t count = court.size();
  std::vector<std::size_t> parent(count + 1);
  for (std::size_t i = 0; i <= count; ++i) parent[i] = i;
  const std::function<std::size_t(std::size_t)> root = [&](std::size_t i) {
    return parent[i] == i ? i : parent[i] = root(parent[i]);
  };
  const auto indexOf = [&](const glm::ivec3& room) {
    return isInside(room) ? roomIndex(room) : count;
  };
  for (int x = -1; x < rooms_.x; ++x) {
    for (int y = -1; y < rooms_.y; ++y) {
      for (int z = -1; z < rooms_.z; ++z) {
        for (int axis = 0; axis < 3; ++axis) {
          const glm::ivec3 below(x, y, z);
          glm::ivec3 above = below;
          ++above[axis];
          const std::size_t a = indexOf(below);
          const std::size_t b = indexOf(above);
          // A court has no wall towards the outside.
          if ((a == count && b < count && court[b]) || (b == count && a < count && court[a])) {
            wall(axis, below).missing = true;
          }
          if (a != b && wall(axis, below).missing) parent[root(a)] = root(b);
        }
      }
    }
  }
  std::vector<CellId> id(count + 1, kNoCell);
  id[root(count)] = kExterior;
  CellId next = 1;
  for (std::size_t i = 0; i < count; ++i) {
    if (id[root(i)] == kNoCell) id[root(i)] = next++;
    cells_.push_back(id[root(i)]);
  }
  graph_.storeys.push_back({"ground", 0});
  graph_.cells.resize(next);
}

void BoxHouse::makePortals() {
  for (int axis = 0; axis < 3; ++axis) {
    for (int x = -1; x < rooms_.x; ++x) {
      for (int y = -1; y < rooms_.y; ++y) {
        for (int z = -1; z < rooms_.z; ++z) {
          const glm::ivec3 below(x, y, z);
          glm::ivec3 above = below;
          ++above[axis];
          const Wall& w = wall(axis, below);
          if ((!isInside(below) && !isInside(above)) || w.missing || !w.opening) continue;
          openings_.push_back({w.least, w.most});
          if (cellOf(below) == cellOf(above)) continue;
          Portal portal;
          const int u = (axis + 1) % 3;
          const int v = (axis + 2) % 3;
          for (const auto& [at_u, at_v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            glm::dvec3 corner = w.least;
            corner[u] = at_u ? w.most[u] : w.least[u];
            corner[v] = at_v ? w.most[v] : w.least[v];
            portal.polygon.push_back(glm::vec3(corner));
          }
          portal.plane = planeOf(portal.polygon);  // positive along the axis
          portal.front = cellOf(above);
          portal.back = cellOf(below);
          graph_.portals.push_back(portal);
        }
      }
    }
  }
  linkCells(graph_);
}

bool BoxHouse::passes(int axis, int plane, const glm::dvec3& at) const {
  glm::ivec3 below = roomAt(at);
  below[axis] = plane - 1;
  glm::ivec3 above = below;
  above[axis] = plane;
  if (!isInside(below) && !isInside(above)) return true;
  const Wall& w = wall(axis, below);
  if (w.missing) return true;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  return w.opening && at[u] >= w.least[u] && at[u] <= w.most[u] && at[v] >= w.least[v] &&
         at[v] <= w.most[v];
}

bool BoxHouse::liesWhereWallsMeet(const glm::dvec3& p) const {
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& planes = planes_[static_cast<std::size_t>(axis)];
    count += std::find(planes.begin(), planes.end(), p[axis]) != planes.end();
  }
  return count > 1;
}

bool BoxHouse::sees(const glm::dvec3& a, const glm::dvec3& b) const {
  if (liesWhereWallsMeet(a) || liesWhereWallsMeet(b)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& planes = planes_[static_cast<std::size_t>(axis)];
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const double da = a[axis] - planes[i];
      const double db = b[axis] - planes[i];
      if (da * db > 0) continue;
      if (da == 0 && !passes(axis, static_cast<int>(i), a)) return false;
      if (db == 0 && !passes(axis, static_cast<int>(i), b)) return false;
      if (da == 0 || db == 0) continue;
      if (!passes(axis, static_cast<int>(i), a + da / (da - db) * (b - a))) return false;
    }
  }
  return true;
}

glm::vec3 randomPoint(std::mt19937& random, const BoxHouse& house, double margin) {
  const glm::dvec3 least = house.least() - margin;
  const glm::dvec3 most = house.most() + margin;
  glm::dvec3 p;
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] = std::uniform_real_distribution<double>(least[axis], most[axis])(random);
  }
  return glm::vec3(p);
}

glm::vec3 pointAtAnOpening(std::mt19937& random, const BoxHouse& house) {
  const auto& [least, most] = house.openings()[random() % house.openings().size()];
  glm::vec3 p;
  for (int axis = 0; axis < 3; ++axis) {
    const double kinds[] = {0, 1, 0.5, uniform(random, 0, 1), uniform(random, -0.5, 1.5)};
    p[axis] = static_cast<float>(glm::mix(least[axis], most[axis], kinds[random() % 5]));
    const float offs[] = {0, 0, 1e-6f, 1e-4f, 1e-2f, 0.14f, 0.16f};
    p[axis] += offs[random() % 7] * (random() % 2 ? 1.0f : -1.0f);
  }
  return p;
}

}  // namespace enfilade::testing
