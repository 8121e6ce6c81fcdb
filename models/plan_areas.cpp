#include "models/plan_areas.h"

#include <fmt/format.h>

#include "models/polygon.h"
#include "scene/error.h"

namespace enfilade {
namespace {

constexpr int kNothing = -3;

[[noreturn]] void fail(const std::string& subject, const std::string& reason) {
  throw Error(ErrorKind::kBadInput, subject, reason);
}

/// The one thing that the plan says lies within `polygon`.
int areaWithin(const PlanStorey& plan, const std::vector<glm::dvec2>& polygon,
               const std::string& subject) {
  int area = kNothing;
  for (const glm::dvec2& p : plan.solids)
    if (containsPoint(polygon, p)) area = kMasonry;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    if (!containsPoint(polygon, plan.rooms[r].at)) continue;
    const int room = static_cast<int>(r);
    if (area != kNothing)
      fail(subject, fmt::format("{} and {} share one area: a wall between them is missing",
                                areaName(plan, area), areaName(plan, room)));
    area = room;
  }
  if (area == kNothing)
    fail(subject,
         fmt::format("no room is named for the area beside [{:.3f}, {:.3f}]; if it is masonry, "
                     "list a point of it under \"solids\"",
                     polygon[0].x, polygon[0].y));
  return area;
}

}  // namespace

PlanAreas findAreas(const PlanStorey& plan, const std::string& subject) {
  PlanAreas areas{tracePlanarFaces(plan.walls, subject), {}};
  std::vector<bool> found(plan.rooms.size(), false);
  for (std::size_t face = 0; face < areas.faces.faces.size(); ++face) {
    const auto polygon = areas.faces.polygon(face);
    const int area = signedArea(polygon) < 0 ? kOutside : areaWithin(plan, polygon, subject);
    areas.area.push_back(area);
    if (area >= 0) found[static_cast<std::size_t>(area)] = true;
  }
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    if (!found[r])
      fail(subject, fmt::format("room {}: no walls enclose its point [{:.3f}, {:.3f}]",
                                plan.rooms[r].name, plan.rooms[r].at.x, plan.rooms[r].at.y));
  return areas;
}

std::string areaName(const PlanStorey& plan, int area) {
  if (area == kMasonry) return "masonry";
  return area == kOutside ? kOutsideName : plan.rooms[static_cast<std::size_t>(area)].name;
}

}  // namespace enfilade
