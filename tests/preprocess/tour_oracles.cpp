#include "tour_oracles.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace enfilade::testing {

namespace {

void eachTriangle(
    const House& house,
    const std::function<void(const glm::dvec3&, const glm::dvec3&, const glm::dvec3&)>& visit) {
  for (std::size_t o = 0; o < house.building.objects.size(); ++o) {
    if (house.object_roles[o] == ObjectRole::kDoor) continue;
    const Object& object = house.building.objects[o];
    const Mesh& mesh = house.building.meshOf(object);
    const auto& positions = house.building.vertex_arrays[mesh.vertices].positions;
    const auto corner = [&](std::size_t i) {
      return glm::dvec3(house.building.worldFromObject(object) *
                        glm::vec4(positions[mesh.indices[i]], 1.0f));
    };
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      visit(corner(i), corner(i + 1), corner(i + 2));
    }
  }
}

// By the Voronoi regions of the triangle, in barycentric coordinates: unlike the library's way.
double toTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                  const glm::dvec3& c) {
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const double d1 = glm::dot(ab, p - a);
  const double d2 = glm::dot(ac, p - a);
  if (d1 <= 0 && d2 <= 0) return glm::length(p - a);
  const double d3 = glm::dot(ab, p - b);
  const double d4 = glm::dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return glm::length(p - b);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return glm::length(p - (a + d1 / (d1 - d3) * ab));
  const double d5 = glm::dot(ab, p - c);
  const double d6 = glm::dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return glm::length(p - c);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return glm::length(p - (a + d2 / (d2 - d6) * ac));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return glm::length(p - (b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b)));
  }
  const double total = va + vb + vc;
  return glm::length(p - (a + ab * (vb / total) + ac * (vc / total)));
}

// By the signs of volumes.
bool meets(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b,
           const glm::dvec3& c) {
  const auto volume = [](const glm::dvec3& o, const glm::dvec3& x, const glm::dvec3& y,
                         const glm::dvec3& z) { return glm::dot(glm::cross(x - o, y - o), z - o); };
  if (volume(a, b, c, p) * volume(a, b, c, q) >= 0) return false;
  const double s1 = volume(p, q, a, b);
  const double s2 = volume(p, q, b, c);
  const double s3 = volume(p, q, c, a);
  return (s1 >= 0 && s2 >= 0 && s3 >= 0) || (s1 <= 0 && s2 <= 0 && s3 <= 0);
}

glm::vec3 viewOf(const TimedPose& pose) {
  return pose.pose.world_from_camera_rotation * glm::vec3(0, 0, -1);
}

}  // namespace

double bruteDistance(const House& house, const glm::vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  eachTriangle(house, [&](const auto& a, const auto& b, const auto& c) {
    least = std::min(least, toTriangle(glm::dvec3(p), a, b, c));
  });
  return least;
}

bool bruteCrosses(const House& house, const glm::vec3& p, const glm::vec3& q) {
  bool crosses = false;
  eachTriangle(house, [&](const auto& a, const auto& b, const auto& c) {
    crosses = crosses || meets(glm::dvec3(p), glm::dvec3(q), a, b, c);
  });
  return crosses;
}

void expectWalked(const House& house, const Tour& tour, int frames) {
  const auto& poses = tour.path.poses;
  ASSERT_EQ(poses.size(), static_cast<std::size_t>(frames));
  CellId before = kNoCell;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose& pose = poses[i].pose;
    EXPECT_GE(bruteDistance(house, pose.position), 0.15) << "pose " << i;
    EXPECT_LT(std::abs(viewOf(poses[i]).y), 0.3f) << "pose " << i;
    EXPECT_GT((pose.world_from_camera_rotation * glm::vec3(0, 1, 0)).y, 0.9f) << "pose " << i;
    EXPECT_NEAR((pose.world_from_camera_rotation * glm::vec3(1, 0, 0)).y, 0.0f, 1e-4f);
    if (i + 1 == poses.size()) break;
    const glm::vec3 next = poses[i + 1].pose.position;
    EXPECT_GT(poses[i + 1].time, poses[i].time);
    EXPECT_FALSE(bruteCrosses(house, pose.position, next)) << "after pose " << i;
    for (int k = 0; k < 20; ++k) {
      const glm::vec3 p = glm::mix(pose.position, next, static_cast<float>(k) / 20.0f);
      const CellLocation at = locate(house.graph, house.grid, p);
      EXPECT_TRUE(at.in_free_space) << "after pose " << i;
      const bool joined = std::any_of(house.graph.portals.begin(), house.graph.portals.end(),
                                      [&](const Portal& portal) {
                                        return (portal.front == before && portal.back == at.cell) ||
                                               (portal.back == before && portal.front == at.cell);
                                      });
      EXPECT_TRUE(before == kNoCell || before == at.cell || joined) << "after pose " << i;
      before = at.cell;
    }
  }
}

float longestStep(const Tour& tour) {
  float most = 0;
  const auto& poses = tour.path.poses;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    most = std::max(most, glm::length(poses[i].pose.position - poses[i - 1].pose.position));
  }
  return most;
}

float sharpestTurn(const Tour& tour) {
  float most = 0;
  const auto& poses = tour.path.poses;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const float cosine = glm::dot(viewOf(poses[i]), viewOf(poses[i - 1]));
    most = std::max(most, std::acos(std::clamp(cosine, -1.0f, 1.0f)));
  }
  return most;
}

float lengthOf(const Tour& tour) {
  float length = 0;
  const auto& poses = tour.path.poses;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    length += glm::length(poses[i].pose.position - poses[i - 1].pose.position);
  }
  return length;
}

bool noted(const Tour& tour, const std::vector<std::string>& words) {
  return std::any_of(tour.notes.begin(), tour.notes.end(), [&](const std::string& note) {
    return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      return note.find(word) != std::string::npos;
    });
  });
}

}  // namespace enfilade::testing
