#include "models/plan_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/planar_faces.h"
#include "models/polygon.h"
#include "scene/error.h"

namespace enfilade {
namespace {

constexpr int kSolid = -2;           // an area of masonry
constexpr double kOnWall = 1e-3;     // an opening's middle lies this near to the centre line [m]
constexpr double kLeastPier = 0.05;  // of wall beside an opening, and above it [m]

const char* word(OpeningKind kind) {
  switch (kind) {
    case OpeningKind::kDoor:
      return "door";
    case OpeningKind::kWindow:
      return "window";
    case OpeningKind::kOpening:
      break;
  }
  return "opening";
}

class Layouter {
 public:
  Layouter(const FloorPlan& plan, const std::string& subject)
      : plan_(plan), subject_(subject), faces_(tracePlanarFaces(plan.walls, subject)) {}

  Layout run() {
    assignAreas();
    layout_.rooms.resize(plan_.rooms.size());
    for (std::size_t face = 0; face < faces_.faces.size(); ++face)
      if (area_[face] != kSolid) outlineOf(area_[face]) = traceOutline(face);
    for (std::size_t i = 0; i < plan_.openings.size(); ++i) placeOpening(i);
    for (std::size_t r = 0; r < plan_.rooms.size(); ++r) sortOpenings(layout_.rooms[r]);
    sortOpenings(layout_.outside);
    checkFittings();
    return std::move(layout_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(ErrorKind::kBadInput, subject_, reason);
  }

  std::string nameOf(int area) const {
    if (area == kSolid) return "masonry";
    return area == kOutside ? kOutsideName : plan_.rooms[static_cast<std::size_t>(area)].name;
  }

  Outline& outlineOf(int area) {
    return area == kOutside ? layout_.outside : layout_.rooms[static_cast<std::size_t>(area)];
  }

  /// Gives every enclosed face its room, or masonry.
  void assignAreas() {
    constexpr int kNothing = -3;
    area_.assign(faces_.faces.size(), kNothing);
    std::vector<int> face_of_room(plan_.rooms.size(), -1);
    for (std::size_t face = 0; face < faces_.faces.size(); ++face) {
      const auto polygon = faces_.polygon(face);
      if (signedArea(polygon) < 0) {
        area_[face] = kOutside;
        continue;
      }
      for (const glm::dvec2& p : plan_.solids)
        if (containsPoint(polygon, p)) area_[face] = kSolid;
      for (std::size_t r = 0; r < plan_.rooms.size(); ++r) {
        if (!containsPoint(polygon, plan_.rooms[r].at)) continue;
        const int room = static_cast<int>(r);
        if (area_[face] != kNothing)
          fail(fmt::format("rooms {} and {} share one area: a wall between them is missing",
                           nameOf(area_[face]), plan_.rooms[r].name));
        area_[face] = room;
        face_of_room[r] = static_cast<int>(face);
      }
      if (area_[face] == kNothing)
        fail(
            fmt::format("no room is named for the area beside [{:.3f}, {:.3f}]; if it is masonry, "
                        "list a point of it under \"solids\"",
                        polygon[0].x, polygon[0].y));
    }
    for (std::size_t r = 0; r < plan_.rooms.size(); ++r)
      if (face_of_room[r] < 0)
        fail(fmt::format("room {}: no walls enclose its point [{:.3f}, {:.3f}]",
                         plan_.rooms[r].name, plan_.rooms[r].at.x, plan_.rooms[r].at.y));
  }

  double halfThickness(std::size_t half) const {
    return 0.5 * plan_.walls[faces_.halves[half].wall].thickness;
  }

  glm::dvec2 directionOf(std::size_t half) const {
    return glm::normalize(faces_.end(half) - faces_.start(half));
  }

  bool sameStretch(std::size_t a, std::size_t b) const {
    return glm::dot(directionOf(a), directionOf(b)) > 1 - 1e-9 &&
           std::abs(halfThickness(a) - halfThickness(b)) < 1e-9;
  }

  /// Moves the face's edges inward by half of each wall's thickness.
  Outline traceOutline(std::size_t face) {
    std::vector<std::size_t> halves = faces_.faces[face];
    // Begin at a true corner, so that no stretch is cut by the beginning of the list.
    const std::size_t n = halves.size();
    std::size_t corner = 0;
    while (corner + 1 < n && sameStretch(halves[(corner + n - 1) % n], halves[corner])) ++corner;
    std::rotate(halves.begin(), halves.begin() + static_cast<std::ptrdiff_t>(corner), halves.end());
    std::vector<std::vector<std::size_t>> stretches;
    for (const std::size_t half : halves) {
      if (stretches.empty() || !sameStretch(stretches.back().back(), half))
        stretches.emplace_back();
      stretches.back().push_back(half);
    }
    Outline outline;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const std::size_t before = stretches[(i + stretches.size() - 1) % stretches.size()].back();
      const std::size_t after = stretches[(i + 1) % stretches.size()].front();
      addStretch(before, stretches[i], after, outline);
    }
    if (signedArea(outline.corners()) * signedArea(faces_.polygon(face)) <= 0)
      fail(fmt::format("{}: its walls are so thick that nothing is left", nameOf(area_[face])));
    return outline;
  }

  void addStretch(std::size_t before, const std::vector<std::size_t>& stretch, std::size_t after,
                  Outline& outline) {
    const glm::dvec2 d = directionOf(stretch.front());
    const double h = halfThickness(stretch.front());
    LayoutEdge edge;
    edge.inward = leftOf(d);
    edge.from = cornerOf(before, stretch.front(), h, edge.inward);
    edge.to = cornerOf(stretch.back(), after, h, edge.inward);
    if (glm::dot(edge.to - edge.from, d) < 0.01)
      fail(fmt::format("walls[{}]: the walls beside it leave nothing of it",
                       faces_.halves[stretch.front()].wall));
    if (edge_of_half_.empty()) edge_of_half_.resize(faces_.halves.size());
    for (const std::size_t half : stretch) edge_of_half_[half] = outline.edges.size();
    outline.edges.push_back(edge);
    // Walls of other thickness in one line: a small step joins their faces.
    if (glm::dot(d, directionOf(after)) > 1 - 1e-9) {
      LayoutEdge step;
      step.from = edge.to;
      step.to = faces_.start(after) + edge.inward * halfThickness(after);
      step.inward = leftOf(glm::normalize(step.to - step.from));
      outline.edges.push_back(step);
    }
  }

  /// The corner between two halves on the face of the one with half thickness `h`.
  glm::dvec2 cornerOf(std::size_t a, std::size_t b, double h, const glm::dvec2& inward) const {
    const glm::dvec2 at = faces_.start(b);
    if (glm::dot(directionOf(a), directionOf(b)) > 1 - 1e-9) return at + inward * h;
    return movedCorner(at, directionOf(a), halfThickness(a), directionOf(b), halfThickness(b));
  }

  std::string label(std::size_t i) const {
    const PlanOpening& o = plan_.openings[i];
    return fmt::format("openings[{}] ({} {}–{})", i, word(o.kind), o.between[0], o.between[1]);
  }

  std::size_t halfAt(std::size_t i) const {
    const glm::dvec2 p = plan_.openings[i].at;
    for (std::size_t h = 0; h < faces_.halves.size(); ++h) {
      const glm::dvec2 a = faces_.start(h), d = directionOf(h);
      const double t = glm::dot(p - a, d);
      if (std::abs(cross(d, p - a)) < kOnWall && t > 0 && t < glm::distance(a, faces_.end(h)))
        return h;
    }
    fail(fmt::format("{}: no wall runs through [{:.3f}, {:.3f}]", label(i), p.x, p.y));
  }

  void placeOpening(std::size_t i) {
    const PlanOpening& plan = plan_.openings[i];
    std::size_t half = halfAt(i);
    const int wanted = plan_.roomIndex(plan.between[0]);
    if (area_[faces_.halves[half].face] != wanted) half = faces_.halves[half].twin;
    const std::size_t twin = faces_.halves[half].twin;
    const int one = area_[faces_.halves[half].face], other = area_[faces_.halves[twin].face];
    if (one != wanted || other == kSolid || other == one ||
        other != plan_.roomIndex(plan.between[1]))
      fail(fmt::format("{}: its wall stands between {} and {}", label(i), nameOf(one),
                       nameOf(other)));
    LayoutOpening opening;
    opening.plan = i;
    opening.sides = {sideOf(half, plan, one), sideOf(twin, plan, other)};
    layout_.openings.push_back(opening);
    addToEdge(half, i, 0);
    addToEdge(twin, i, 1);
  }

  OpeningSide sideOf(std::size_t half, const PlanOpening& plan, int room) const {
    const glm::dvec2 d = directionOf(half), a = faces_.start(half);
    const glm::dvec2 at = a + d * glm::dot(plan.at - a, d);
    OpeningSide side;
    side.room = room;
    side.inward = leftOf(d);
    side.middle_first = at - d * (0.5 * plan.width);
    side.middle_second = at + d * (0.5 * plan.width);
    side.first = side.middle_first + side.inward * halfThickness(half);
    side.second = side.middle_second + side.inward * halfThickness(half);
    return side;
  }

  void addToEdge(std::size_t half, std::size_t i, int side_index) {
    const OpeningSide& side = layout_.openings[i].sides[static_cast<std::size_t>(side_index)];
    LayoutEdge& edge = outlineOf(side.room).edges[edge_of_half_[half]];
    const double start = glm::dot(side.first - edge.from, edge.direction());
    const double end = glm::dot(side.second - edge.from, edge.direction());
    if (start < kLeastPier || end > edge.length() - kLeastPier)
      fail(
          fmt::format("{}: reaches beyond its wall, which is {:.3f} m long in {}; the opening "
                      "would run from {:.3f} to {:.3f} m",
                      label(i), edge.length(), nameOf(side.room), start, end));
    const double height = side.room == kOutside
                              ? plan_.height
                              : plan_.rooms[static_cast<std::size_t>(side.room)].height;
    if (plan_.openings[i].head > height - kLeastPier)
      fail(fmt::format("{}: its head at {:.3f} m is too high for {}, which is {:.3f} m high",
                       label(i), plan_.openings[i].head, nameOf(side.room), height));
    edge.openings.push_back({i, side_index, start, end});
  }

  void sortOpenings(Outline& outline) const {
    for (LayoutEdge& edge : outline.edges) {
      std::sort(edge.openings.begin(), edge.openings.end(),
                [](const EdgeOpening& a, const EdgeOpening& b) { return a.start < b.start; });
      for (std::size_t k = 1; k < edge.openings.size(); ++k)
        if (edge.openings[k].start < edge.openings[k - 1].end + kLeastPier)
          fail(fmt::format("{} and {} overlap", label(edge.openings[k - 1].opening),
                           label(edge.openings[k].opening)));
    }
  }

  void checkFittings() const {
    const auto outside = layout_.outside.corners();
    for (std::size_t i = 0; i < plan_.fittings.size(); ++i) {
      const PlanFitting& f = plan_.fittings[i];
      const int room = plan_.roomIndex(f.room);
      const bool inside =
          room == kOutside
              ? !containsPoint(outside, f.at)
              : containsPoint(layout_.rooms[static_cast<std::size_t>(room)].corners(), f.at);
      if (!inside)
        fail(fmt::format("fittings[{}] ({}): [{:.3f}, {:.3f}] is not in {}", i, f.piece, f.at.x,
                         f.at.y, f.room));
    }
  }

  const FloorPlan& plan_;
  const std::string& subject_;
  PlanarFaces faces_;
  std::vector<int> area_;                  // of each face: a room, kOutside or kSolid
  std::vector<std::size_t> edge_of_half_;  // in its face's outline
  Layout layout_;
};

}  // namespace

std::vector<glm::dvec2> Outline::corners() const {
  std::vector<glm::dvec2> points;
  for (const LayoutEdge& edge : edges) points.push_back(edge.from);
  return points;
}

Layout layOut(const FloorPlan& plan, const std::string& subject) {
  return Layouter(plan, subject).run();
}

}  // namespace enfilade
