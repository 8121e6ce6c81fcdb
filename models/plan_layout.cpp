#include "models/plan_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/plan_outlines.h"
#include "models/plan_storeys.h"
#include "models/polygon.h"
#include "scene/error.h"

namespace enfilade {
namespace {

constexpr double kOnWall = 1e-3;     // an opening's middle lies this near to the centre line [m]
constexpr double kLeastPier = 0.05;  // of wall beside an opening, and above it [m]

class Layouter {
 public:
  Layouter(const PlanStorey& plan, const std::string& subject)
      : plan_(plan),
        subject_(subject),
        areas_(findAreas(plan, subject)),
        faces_(areas_.faces),
        outlines_(traceOutlines(plan, areas_, subject)) {}

  Layout run() {
    layout_.rooms.resize(plan_.rooms.size());
    for (std::size_t face = 0; face < faces_.faces.size(); ++face)
      if (areas_.area[face] != kMasonry)
        layout_.outlineOf(areas_.area[face]) = outlines_.of_face[face];
    for (std::size_t i = 0; i < plan_.openings.size(); ++i) placeOpening(i);
    for (Outline& outline : layout_.rooms) sortOpenings(outline);
    sortOpenings(layout_.outside);
    checkFittings();
    return std::move(layout_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(ErrorKind::kBadInput, subject_, reason);
  }

  std::string label(std::size_t i) const {
    const PlanOpening& o = plan_.openings[i];
    return fmt::format("openings[{}] ({} {}–{})", i, kindWord(o.kind), o.between[0], o.between[1]);
  }

  std::size_t halfAt(std::size_t i) const {
    const glm::dvec2 p = plan_.openings[i].at;
    for (std::size_t h = 0; h < faces_.halves.size(); ++h) {
      const glm::dvec2 a = faces_.start(h), d = faces_.direction(h);
      const double t = glm::dot(p - a, d);
      if (std::abs(planCross(d, p - a)) < kOnWall && t > 0 && t < glm::distance(a, faces_.end(h)))
        return h;
    }
    fail(fmt::format("{}: no wall runs through [{:.3f}, {:.3f}]", label(i), p.x, p.y));
  }

  void placeOpening(std::size_t i) {
    const PlanOpening& plan = plan_.openings[i];
    std::size_t half = halfAt(i);
    const int wanted = plan_.roomIndex(plan.between[0]);
    if (areas_.areaLeftOf(half) != wanted) half = faces_.halves[half].twin;
    const std::size_t twin = faces_.halves[half].twin;
    const int one = areas_.areaLeftOf(half), other = areas_.areaLeftOf(twin);
    if (one != wanted || other == kMasonry || other == one ||
        other != plan_.roomIndex(plan.between[1]))
      fail(fmt::format("{}: its wall stands between {} and {}", label(i), areaName(plan_, one),
                       areaName(plan_, other)));
    layout_.openings.push_back({i, sidesOf(half, plan)});
    addToEdge(half, i, 0);
    addToEdge(twin, i, 1);
  }

  /// Both sides share their jambs in the middle of the wall, to the last bit.
  std::array<OpeningSide, 2> sidesOf(std::size_t half, const PlanOpening& plan) const {
    const glm::dvec2 d = faces_.direction(half), a = faces_.start(half), n = leftOf(d);
    const glm::dvec2 at = a + d * glm::dot(plan.at - a, d);
    const glm::dvec2 first = at - d * (0.5 * plan.width), second = at + d * (0.5 * plan.width);
    const glm::dvec2 out = n * (0.5 * plan_.walls[faces_.halves[half].wall].thickness);
    const int one = areas_.areaLeftOf(half);
    const int other = areas_.areaLeftOf(faces_.halves[half].twin);
    return {{{one, first + out, second + out, first, second, n},
             {other, second - out, first - out, second, first, -n}}};
  }

  void addToEdge(std::size_t half, std::size_t i, int side_index) {
    const OpeningSide& side = layout_.openings[i].sides[static_cast<std::size_t>(side_index)];
    LayoutEdge& edge = layout_.outlineOf(side.room).edges[outlines_.edge_of_half[half]];
    const double start = glm::dot(side.first - edge.from, edge.direction());
    const double end = glm::dot(side.second - edge.from, edge.direction());
    if (start < kLeastPier || end > edge.length() - kLeastPier)
      fail(
          fmt::format("{}: reaches beyond its wall, which is {:.3f} m long in {}; the opening "
                      "would run from {:.3f} to {:.3f} m",
                      label(i), edge.length(), areaName(plan_, side.room), start, end));
    const double height = side.room == kOutside
                              ? plan_.height
                              : plan_.rooms[static_cast<std::size_t>(side.room)].height;
    if (plan_.openings[i].head > height - kLeastPier)
      fail(fmt::format("{}: its head at {:.3f} m is too high for {}, which is {:.3f} m high",
                       label(i), plan_.openings[i].head, areaName(plan_, side.room), height));
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
    for (std::size_t i = 0; i < plan_.fittings.size(); ++i) {
      const PlanFitting& f = plan_.fittings[i];
      const int room = plan_.roomIndex(f.room);
      if (containsPoint(layout_.outlineOf(room).corners(), f.at) == (room == kOutside))
        fail(fmt::format("fittings[{}] ({}): [{:.3f}, {:.3f}] is not in {}", i, f.piece, f.at.x,
                         f.at.y, f.room));
    }
  }

  const PlanStorey& plan_;
  const std::string subject_;
  const PlanAreas areas_;
  const PlanarFaces& faces_;
  const PlanOutlines outlines_;
  Layout layout_;
};

}  // namespace

std::vector<glm::dvec2> Outline::corners() const {
  std::vector<glm::dvec2> points;
  for (const LayoutEdge& edge : edges) points.push_back(edge.from);
  return points;
}

std::vector<Layout> layOut(const FloorPlan& plan, const std::string& subject) {
  std::vector<Layout> layouts;
  for (const PlanStorey& storey : plan.storeys)
    layouts.push_back(
        Layouter(storey, plan.storeys.size() > 1 ? subject + ": storey " + storey.name : subject)
            .run());
  checkStoreys(plan, layouts, subject);
  return layouts;
}

}  // namespace enfilade
