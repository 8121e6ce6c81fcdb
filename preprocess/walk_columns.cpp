#include "preprocess/walk_columns.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "portals/open_doors.h"

namespace enfilade {

namespace {

constexpr float kMergeGap = 0.01f;       // [m] thinner gaps between spans hold nobody
constexpr float kSameTop = 0.02f;        // [m] tops this close are one: the flatter decides
constexpr float kTouch = 1e-4f;          // [m] a face on a grid line belongs to both sides
constexpr float kSteepest = 0.643f;      // cos 50°
constexpr float kUpright = 0.05f;        // |normal.y| below it is a wall, whose top edge is a step
constexpr float kOffset = 0.37f;         // of a column: keeps round coordinates off the grid lines
constexpr std::size_t kMostCorners = 8;  // a triangle clipped by four lines has at most seven

struct ClippedPolygon {
  std::array<glm::vec3, kMostCorners> corners;
  std::size_t count = 0;
};

// The part of `in` where sign · (p[axis] − at) ≥ 0.
ClippedPolygon clip(const ClippedPolygon& in, int axis, float at, float sign) {
  ClippedPolygon out;
  for (std::size_t i = 0; i < in.count; ++i) {
    const glm::vec3& a = in.corners[i];
    const glm::vec3& b = in.corners[(i + 1) % in.count];
    const float da = sign * (a[axis] - at);
    const float db = sign * (b[axis] - at);
    if (da >= 0 && out.count < kMostCorners) out.corners[out.count++] = a;
    if ((da >= 0) != (db >= 0) && out.count < kMostCorners) {
      out.corners[out.count++] = a + (b - a) * (da / (da - db));
    }
  }
  return out;
}

void insertSpan(std::vector<SolidSpan>& spans, SolidSpan span) {
  auto first = spans.begin();
  while (first != spans.end() && first->top < span.bottom - kMergeGap) ++first;
  auto last = first;
  for (; last != spans.end() && last->bottom <= span.top + kMergeGap; ++last) {
    if (std::abs(last->top - span.top) <= kSameTop) {
      span.steep = span.steep && last->steep;
    } else if (last->top > span.top) {
      span.steep = last->steep;
    }
    span.bottom = std::min(span.bottom, last->bottom);
    span.top = std::max(span.top, last->top);
  }
  if (first == last) {
    spans.insert(first, span);
  } else {
    *first = span;
    spans.erase(first + 1, last);
  }
}

class Rasteriser {
 public:
  explicit Rasteriser(WalkColumns& columns) : columns_(columns) {}

  void add(const WorldTriangle& t) {
    const glm::vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const float length = glm::length(normal);
    const float up = length > 0 ? std::abs(normal.y) / length : 0.0f;
    const bool steep = up > kUpright && up < kSteepest;
    ClippedPolygon whole;
    std::copy(t.begin(), t.end(), whole.corners.begin());
    whole.count = 3;
    const auto [x0, x1] = range(whole, 0);
    for (int x = std::max(x0, 0); x <= std::min(x1, columns_.size.x - 1); ++x) {
      addStrip(slab(whole, 0, x, x0 == x1), x, steep);
    }
  }

 private:
  void addStrip(const ClippedPolygon& strip, int x, bool steep) {
    if (strip.count == 0) return;
    const auto [z0, z1] = range(strip, 2);
    for (int z = std::max(z0, 0); z <= std::min(z1, columns_.size.y - 1); ++z) {
      const ClippedPolygon part = slab(strip, 2, z, z0 == z1);
      if (part.count == 0) continue;
      SolidSpan span{part.corners[0].y, part.corners[0].y, steep};
      for (std::size_t i = 1; i < part.count; ++i) {
        span.bottom = std::min(span.bottom, part.corners[i].y);
        span.top = std::max(span.top, part.corners[i].y);
      }
      insertSpan(columns_.spans[columns_.index({x, z})], span);
    }
  }

  float lineAt(int axis, int i) const {
    return columns_.origin[axis / 2] + static_cast<float>(i) * columns_.pitch;
  }

  ClippedPolygon slab(const ClippedPolygon& in, int axis, int i, bool whole) const {
    if (whole) return in;
    return clip(clip(in, axis, lineAt(axis, i) - kTouch, 1.0f), axis, lineAt(axis, i + 1) + kTouch,
                -1.0f);
  }

  // The first and the last column that the polygon touches; they may lie outside the grid.
  std::pair<int, int> range(const ClippedPolygon& polygon, int axis) const {
    float least = polygon.corners[0][axis];
    float most = least;
    for (std::size_t i = 1; i < polygon.count; ++i) {
      least = std::min(least, polygon.corners[i][axis]);
      most = std::max(most, polygon.corners[i][axis]);
    }
    const auto column = [&](float v) {
      const float at = (v - columns_.origin[axis / 2]) / columns_.pitch;
      return static_cast<int>(std::floor(at));
    };
    return {column(least - kTouch), column(most + kTouch)};
  }

  WalkColumns& columns_;
};

}  // namespace

void forEachObstacle(const House& house, DoorsStand doors,
                     const std::function<void(const WorldTriangle&)>& visit) {
  const Building& building = house.building;
  const std::vector<std::uint8_t> open =
      doors == DoorsStand::kAllOpen ? doorFlags(house.object_roles) : openDoors(house);
  for (std::size_t o = 0; o < building.objects.size(); ++o) {
    if (o < open.size() && open[o]) continue;
    const Object& object = building.objects[o];
    const Mesh& mesh = building.meshOf(object);
    const std::vector<glm::vec3>& positions = building.vertex_arrays[mesh.vertices].positions;
    const glm::mat4& world_from_object = building.worldFromObject(object);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      WorldTriangle t;
      for (std::size_t k = 0; k < 3; ++k) {
        t[k] = glm::vec3(world_from_object * glm::vec4(positions[mesh.indices[i + k]], 1.0f));
      }
      const glm::vec3 sum = t[0] + t[1] + t[2];
      if (std::isfinite(sum.x + sum.y + sum.z)) visit(t);
    }
  }
}

WalkColumns rasteriseColumns(const House& house, float pitch, const Box& bounds, DoorsStand doors) {
  WalkColumns columns;
  if (bounds.empty()) return columns;
  columns.pitch = pitch;
  columns.origin = glm::vec2(bounds.min.x, bounds.min.z) - kOffset * pitch;
  const glm::vec2 far_corner(bounds.max.x, bounds.max.z);
  columns.size = glm::ivec2(glm::floor((far_corner - columns.origin) / pitch)) + 1;
  columns.spans.resize(static_cast<std::size_t>(columns.size.x) *
                       static_cast<std::size_t>(columns.size.y));
  Rasteriser rasteriser(columns);
  forEachObstacle(house, doors, [&](const WorldTriangle& t) { rasteriser.add(t); });
  return columns;
}

}  // namespace enfilade
