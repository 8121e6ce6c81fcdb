#include "preprocess/wall_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace enfilade {

namespace {

constexpr float kBin = 1.0f;             // [m]
constexpr float kParallel = 0.990f;      // cosine of 8°
constexpr float kUpright = 0.17f;        // sine of 10°
constexpr float kSameFace = 0.005f;      // [m]
constexpr std::size_t kAngleBins = 180;  // over a right angle

/// The part of a convex polygon on the side of lo ≤ p[axis], or with `upper` of p[axis] ≤ lo.
std::vector<glm::vec3> clipped(const std::vector<glm::vec3>& polygon, int axis, float at,
                               bool upper) {
  std::vector<glm::vec3> kept;
  const auto inside = [&](const glm::vec3& p) { return upper ? at - p[axis] : p[axis] - at; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const float da = inside(a), db = inside(b);
    if (da >= 0) kept.push_back(a);
    if ((da < 0) != (db < 0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

/// The part of a triangle in lo…hi.
std::vector<glm::vec3> clipToBox(const std::array<glm::vec3, 3>& triangle, const glm::vec3& lo,
                                 const glm::vec3& hi) {
  std::vector<glm::vec3> polygon(triangle.begin(), triangle.end());
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = clipped(clipped(polygon, axis, lo[axis], false), axis, hi[axis], true);
  }
  return polygon;
}

float areaOf(const std::vector<glm::vec3>& polygon) {
  glm::vec3 twice(0.0f);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return 0.5f * glm::length(twice);
}

/// Faces at the same offset as one, at their mean offset by area.
std::vector<WallFaces::Face> joined(std::vector<WallFaces::Face> faces) {
  std::stable_sort(faces.begin(), faces.end(),
                   [](const auto& a, const auto& b) { return a.offset < b.offset; });
  std::vector<WallFaces::Face> result;
  for (const WallFaces::Face& face : faces) {
    if (!result.empty() && face.offset - result.back().offset < kSameFace) {
      WallFaces::Face& last = result.back();
      const float area = last.area + face.area;
      last.offset = (last.offset * last.area + face.offset * face.area) / area;
      last.area = area;
    } else {
      result.push_back(face);
    }
  }
  return result;
}

}  // namespace

WallFaces::WallFaces(const Building& building, std::span<const ObjectRole> roles) {
  Box all;
  for (std::size_t o = 0; o < building.objects.size(); ++o) {
    const Object& object = building.objects[o];
    if (roles[o] != ObjectRole::kFixed) continue;
    if (building.materialOf(object).alpha_mode == AlphaMode::kBlend) continue;
    const Mesh& mesh = building.meshOf(object);
    const auto& positions = building.vertex_arrays[mesh.vertices].positions;
    const glm::mat4& world_from_object = building.worldFromObject(object);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      Triangle t{};
      for (std::size_t k = 0; k < 3; ++k) {
        t.corners[k] = world_from_object * glm::vec4(positions[mesh.indices[i + k]], 1.0f);
      }
      const glm::vec3 normal = glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
      const float length = glm::length(normal);
      if (!(length > 1e-9f)) continue;
      t.normal = normal / length;
      for (const glm::vec3& p : t.corners) all.extend(p);
      triangles_.push_back(t);
    }
  }
  if (triangles_.empty()) return;
  origin_ = {all.min.x, all.min.z};
  bins_x_ = static_cast<int>(all.size().x / kBin) + 1;
  bins_z_ = static_cast<int>(all.size().z / kBin) + 1;
  bins_.resize(static_cast<std::size_t>(bins_x_) * static_cast<std::size_t>(bins_z_));
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    Box box;
    for (const glm::vec3& p : triangles_[i].corners) box.extend(p);
    const glm::ivec2 lo((glm::vec2(box.min.x, box.min.z) - origin_) / kBin);
    const glm::ivec2 hi((glm::vec2(box.max.x, box.max.z) - origin_) / kBin);
    for (int x = lo.x; x <= hi.x; ++x) {
      for (int z = lo.y; z <= hi.y; ++z) bins_[binOf(x, z)].push_back(i);
    }
  }
}

std::size_t WallFaces::binOf(int x, int z) const {
  return static_cast<std::size_t>(std::clamp(x, 0, bins_x_ - 1)) *
             static_cast<std::size_t>(bins_z_) +
         static_cast<std::size_t>(std::clamp(z, 0, bins_z_ - 1));
}

void WallFaces::collect(const Box& box, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (triangles_.empty()) return;
  const glm::ivec2 lo(glm::floor((glm::vec2(box.min.x, box.min.z) - origin_) / kBin));
  const glm::ivec2 hi(glm::floor((glm::vec2(box.max.x, box.max.z) - origin_) / kBin));
  for (int x = std::max(lo.x, 0); x <= std::min(hi.x, bins_x_ - 1); ++x) {
    for (int z = std::max(lo.y, 0); z <= std::min(hi.y, bins_z_ - 1); ++z) {
      const auto& bin = bins_[binOf(x, z)];
      found.insert(found.end(), bin.begin(), bin.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

std::vector<WallFaces::Face> WallFaces::facesAcross(const TurnedBox& box, int axis) const {
  Box world;
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 p(i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                      i & 4 ? box.hi.z : box.lo.z);
    world.extend(box.center + box.axes * p);
  }
  std::vector<std::uint32_t> near;
  collect(world, near);
  std::vector<Face> faces;
  const glm::mat3 local_from_world = glm::transpose(box.axes);
  for (const std::uint32_t i : near) {
    const Triangle& t = triangles_[i];
    if (std::abs(glm::dot(t.normal, box.axes[axis])) < kParallel) continue;
    std::array<glm::vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = local_from_world * (t.corners[k] - box.center);
    const auto inside = clipToBox(corners, box.lo, box.hi);
    const float area = areaOf(inside);
    if (area < 1e-6f) continue;
    float offset = 0;
    for (const glm::vec3& p : inside) offset += p[axis] / static_cast<float>(inside.size());
    faces.push_back({offset, area});
  }
  return joined(std::move(faces));
}

float WallFaces::wallAngle(const Box& box) const {
  std::vector<std::uint32_t> near;
  collect(box, near);
  constexpr float kRightAngle = std::numbers::pi_v<float> / 2;
  // Fourfold angles, so that walls at right angles add up.
  std::array<float, kAngleBins> area{};
  std::array<glm::vec2, kAngleBins> sum{};
  for (const std::uint32_t i : near) {
    const Triangle& t = triangles_[i];
    if (std::abs(t.normal.y) > kUpright) continue;
    const float weight =
        areaOf(clipToBox({t.corners[0], t.corners[1], t.corners[2]}, box.min, box.max));
    float angle = std::fmod(std::atan2(t.normal.x, t.normal.z) + 4 * kRightAngle, kRightAngle);
    const auto bin = static_cast<std::size_t>(angle / kRightAngle * kAngleBins) % kAngleBins;
    area[bin] += weight;
    sum[bin] += weight * glm::vec2(std::cos(4 * angle), std::sin(4 * angle));
  }
  std::size_t best = 0;
  float most = 0;
  const auto around = [&](const auto& values, std::size_t bin) {
    return values[(bin + kAngleBins - 1) % kAngleBins] + values[bin] +
           values[(bin + 1) % kAngleBins];
  };
  for (std::size_t bin = 0; bin < kAngleBins; ++bin) {
    if (around(area, bin) > most) most = around(area, bin), best = bin;
  }
  if (most <= 0) return -1.0f;
  const glm::vec2 mean = around(sum, best);
  const float angle = std::atan2(mean.y, mean.x) / 4;
  return angle < 0 ? angle + kRightAngle : angle;
}

}  // namespace enfilade
