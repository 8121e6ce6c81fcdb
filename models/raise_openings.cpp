#include "models/raise_openings.h"

#include <fmt/format.h>

#include "models/plan_storeys.h"
#include "models/polygon.h"
#include "scene/polygon_triangles.h"

namespace enfilade {
namespace {

constexpr double kBar = 0.035;         // width of a glazing bar [m]
constexpr double kBorder = 0.055;      // of the frame around
constexpr double kNearMiddle = 0.012;  // the frame's outer face from the wall's middle
constexpr double kFrameDepth = 0.05;

/// Where bars begin and end along one direction: solid, pane, solid, pane … solid.
std::vector<double> latticeBreaks(double length, int panes) {
  std::vector<double> breaks{0, kBorder};
  const double pane = (length - 2 * kBorder - (panes - 1) * kBar) / panes;
  for (int i = 0; i < panes; ++i) {
    breaks.push_back(breaks.back() + pane);
    breaks.push_back(breaks.back() + (i + 1 < panes ? kBar : kBorder));
  }
  breaks.back() = length;
  return breaks;
}

/// A lattice between two planes in a reveal; `along`, `up` from the first jamb's sill.
class Lattice {
 public:
  Lattice(const OpeningSide& side, double sill, MeshBuilder& mesh)
      : origin_(side.middle_first),
        direction_(glm::normalize(side.middle_second - side.middle_first)),
        inward_(side.inward),
        sill_(sill),
        mesh_(mesh) {}

  void bars(double a, double b, double low, double high) {
    const double outer = kNearMiddle, inner = kNearMiddle + kFrameDepth;
    mesh_.flatQuad(at(a, low, inner), at(b, low, inner), at(b, high, inner), at(a, high, inner));
    mesh_.flatQuad(at(b, low, outer), at(a, low, outer), at(a, high, outer), at(b, high, outer));
  }

  void paneSides(double a, double b, double low, double high) {
    const double outer = kNearMiddle, inner = kNearMiddle + kFrameDepth;
    mesh_.flatQuad(at(a, low, inner), at(a, low, outer), at(a, high, outer), at(a, high, inner));
    mesh_.flatQuad(at(b, low, outer), at(b, low, inner), at(b, high, inner), at(b, high, outer));
    mesh_.flatQuad(at(a, low, inner), at(b, low, inner), at(b, low, outer), at(a, low, outer));
    mesh_.flatQuad(at(a, high, outer), at(b, high, outer), at(b, high, inner), at(a, high, inner));
  }

 private:
  Corner at(double along, double up, double out) const {
    const glm::dvec2 p = origin_ + direction_ * along + inward_ * out;
    return {{p.x, sill_ + up, p.y}, {along * 2, -up * 2}, 1};
  }

  glm::dvec2 origin_, direction_, inward_;
  double sill_;
  MeshBuilder& mesh_;
};

void addMarker(BuildingRaiser& raiser, const std::string& name, std::uint32_t parent,
               MeshBuilder& mesh, const std::string& extras) {
  const std::uint32_t index = mesh.addTo(raiser.building(), name, raiser.markerMaterial());
  raiser.addObject(raiser.addNode(name, parent, glm::mat4(1), extras), index);
}

void raisePrism(const std::vector<glm::dvec2>& polygon, double low, double high,
                MeshBuilder& mesh) {
  const auto at = [&](std::size_t i, double y) {
    const glm::dvec2& p = polygon[i % polygon.size()];
    return Corner{{p.x, y, p.y}, p, 1};
  };
  for (std::size_t i = 0; i < polygon.size(); ++i)
    mesh.flatQuad(at(i + 1, low), at(i, low), at(i, high), at(i + 1, high));
  for (const auto& [a, b, c] : triangulate(polygon)) {
    mesh.flatTriangle(at(a, low), at(b, low), at(c, low));
    mesh.flatTriangle(at(a, high), at(c, high), at(b, high));
  }
}

}  // namespace

void raiseWindowFrame(const PlanStorey& plan, const LayoutOpening& opening, MeshBuilder& mesh) {
  const PlanOpening& look = plan.openings[opening.plan];
  const auto across = latticeBreaks(look.width, look.panes.x);
  const auto up = latticeBreaks(look.head - look.sill, look.panes.y);
  Lattice lattice(opening.sides[0], plan.floor + look.sill, mesh);
  for (std::size_t i = 0; i + 1 < across.size(); ++i) {
    for (std::size_t j = 0; j + 1 < up.size(); ++j) {
      const bool pane = i % 2 == 1 && j % 2 == 1;
      if (pane)
        lattice.paneSides(across[i], across[i + 1], up[j], up[j + 1]);
      else
        lattice.bars(across[i], across[i + 1], up[j], up[j + 1]);
    }
  }
}

void PortalMarkers::add(const PlanStorey& storey, const LayoutOpening& opening,
                        std::uint32_t room_node) {
  const PlanOpening& look = storey.openings[opening.plan];
  const OpeningSide& side = opening.sides[0];
  const auto at = [&](const glm::dvec2& p, double y) {
    return Corner{{p.x, storey.floor + y, p.y}, {0, 0}, 1};
  };
  MeshBuilder quad;
  quad.flatQuad(at(side.middle_first, look.sill), at(side.middle_second, look.sill),
                at(side.middle_second, look.head), at(side.middle_first, look.head));
  addQuad(quad, look.between[1], kindWord(look.kind), room_node);
}

void PortalMarkers::add(const PlanWell& well, double level, std::uint32_t upper_room_node) {
  const auto corners = cornersOf(well);
  const auto at = [&](std::size_t i) {
    return Corner{{corners[i].x, level, corners[i].y}, {0, 0}, 1};
  };
  MeshBuilder quad;
  quad.flatQuad(at(3), at(2), at(1), at(0));
  addQuad(quad, well.between[1], kindWord(OpeningKind::kOpening), upper_room_node);
}

void PortalMarkers::addQuad(MeshBuilder& quad, const std::string& to, const char* kind,
                            std::uint32_t node) {
  const int number = ++count_[to];
  const std::string name = number == 1 ? to + "-portal" : fmt::format("{}-portal-{}", to, number);
  addMarker(raiser_, name, node, quad,
            fmt::format(R"({{"portal":{{"kind":"{}","to":"{}"}}}})", kind, to));
}

void addBounds(BuildingRaiser& raiser, const PlanStorey& storey, const Layout& layout,
               std::size_t room, std::uint32_t room_node) {
  const PlanRoom& look = storey.rooms[room];
  const auto corners = layout.rooms[room].corners();
  std::vector<std::vector<glm::dvec2>> parts;
  if (isConvex(corners)) {
    parts.push_back(corners);
  } else {
    for (const auto& [a, b, c] : triangulate(corners))
      parts.push_back({corners[a], corners[b], corners[c]});
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    MeshBuilder prism;
    raisePrism(parts[i], storey.floor, storey.floor + look.height, prism);
    const std::string name =
        i == 0 ? look.name + "-bound" : fmt::format("{}-bound-{}", look.name, i + 1);
    addMarker(raiser, name, room_node, prism, {});
  }
}

}  // namespace enfilade
