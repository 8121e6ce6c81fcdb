#include "models/plan_storeys.h"

#include <fmt/format.h>

#include <algorithm>

#include "models/polygon.h"
#include "scene/error.h"

namespace enfilade {
namespace {

constexpr double kLeastFloor = 0.05;  // between a ceiling and the floor above [m]
constexpr double kLeastLedge = 0.05;  // between a well and a wall, or another well [m]
constexpr double kSamePlace = 1e-6;   // [m]

bool sameOutline(const Outline& a, const Outline& b) {
  // Corners in a line, where walls of the one storey meet and those of the other do not, stand in
  // neither: outlines have true corners only.
  const auto p = a.corners(), q = b.corners();
  if (p.size() != q.size()) return false;
  const auto first = std::find_if(q.begin(), q.end(), [&](const glm::dvec2& corner) {
    return glm::distance(corner, p[0]) < kSamePlace;
  });
  const auto shift = static_cast<std::size_t>(first - q.begin());
  for (std::size_t i = 0; i < p.size(); ++i)
    if (glm::distance(p[i], q[(i + shift) % q.size()]) > kSamePlace) return false;
  return true;
}

/// Whether two rectangles keep `apart` from one another.
bool apart(const PlanWell& a, const PlanWell& b, double least) {
  return a.high.x + least <= b.low.x || b.high.x + least <= a.low.x ||
         a.high.y + least <= b.low.y || b.high.y + least <= a.low.y;
}

/// Whether the rectangle lies inside, no nearer to an edge than `least`.
bool fits(const std::vector<glm::dvec2>& room, const PlanWell& well, double least) {
  const PlanWell grown{{}, well.low - least, well.high + least};
  for (const glm::dvec2& corner : cornersOf(grown))
    if (!containsPoint(room, corner)) return false;
  // A pier that stands out into the room may have all its corners in the well, or an edge across.
  for (std::size_t i = 0; i < room.size(); ++i) {
    const glm::dvec2 a = room[i], b = room[(i + 1) % room.size()];
    for (int step = 0; step <= 64; ++step) {
      const glm::dvec2 p = glm::mix(a, b, step / 64.0);
      if (glm::all(glm::greaterThan(p, grown.low)) && glm::all(glm::lessThan(p, grown.high)))
        return false;
    }
  }
  return true;
}

class StoreyCheck {
 public:
  StoreyCheck(const FloorPlan& plan, const std::vector<Layout>& layouts, const std::string& subject)
      : plan_(plan), layouts_(layouts), subject_(subject) {}

  void run() const {
    for (std::size_t i = 1; i < plan_.storeys.size(); ++i) {
      if (!sameOutline(layouts_[i].outside, layouts_[i - 1].outside))
        fail(fmt::format("storey {}: its outer walls must stand on those of storey {}",
                         plan_.storeys[i].name, plan_.storeys[i - 1].name));
      checkCeilings(plan_.storeys[i - 1]);
      checkWells(i);
    }
  }

 private:
  void checkCeilings(const PlanStorey& storey) const {
    for (const PlanRoom& room : storey.rooms)
      if (room.height > storey.height - kLeastFloor)
        fail(fmt::format("room {}: is {:.3f} m high, and the storey above begins at {:.3f} m",
                         room.name, room.height, storey.height));
  }

  void checkWells(std::size_t storey) const {
    const auto& wells = plan_.storeys[storey].wells;
    for (std::size_t i = 0; i < wells.size(); ++i) {
      for (const std::size_t side : {0u, 1u}) {
        const std::size_t level = storey - side;
        const int room = plan_.storeys[level].roomIndex(wells[i].between[side]);
        if (!fits(layouts_[level].outlineOf(room).corners(), wells[i], kLeastLedge))
          fail(fmt::format("storeys[{}].wells[{}]: must lie in {}, {} m from its walls", storey, i,
                           wells[i].between[side], kLeastLedge));
      }
      for (std::size_t k = 0; k < i; ++k)
        if (!apart(wells[i], wells[k], kLeastLedge))
          fail(fmt::format("storeys[{}].wells[{}]: comes too near to wells[{}]", storey, i, k));
    }
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(ErrorKind::kBadInput, subject_, reason);
  }

  const FloorPlan& plan_;
  const std::vector<Layout>& layouts_;
  const std::string& subject_;
};

}  // namespace

void checkStoreys(const FloorPlan& plan, const std::vector<Layout>& layouts,
                  const std::string& subject) {
  StoreyCheck(plan, layouts, subject).run();
}

std::vector<PlanWell> wellsOf(const std::string& room, std::size_t side,
                              const std::vector<PlanWell>& wells) {
  std::vector<PlanWell> found;
  std::copy_if(wells.begin(), wells.end(), std::back_inserter(found),
               [&](const PlanWell& well) { return well.between[side] == room; });
  return found;
}

std::vector<glm::dvec2> cornersOf(const PlanWell& well) {
  return {well.low, {well.high.x, well.low.y}, well.high, {well.low.x, well.high.y}};
}

}  // namespace enfilade
