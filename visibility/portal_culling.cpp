#include "visibility/portal_culling.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>

#include "portals/polygon.h"

namespace enfilade {

namespace {

/// A region more than this in one cell, and they are merged: keeps pathological graphs (hundreds of
/// windows around a court) from exploding.  Conservative: draws more, never less.
constexpr std::size_t kMostRegions = 64;

/// Off a portal's plane by this much [m] on the wrong side, an eye still counts as on it.
constexpr float kPlaneTolerance = 1e-3f;

/// Drops every region that lies within another one.
void dropContained(std::vector<ScreenRegion>& regions) {
  for (std::size_t i = regions.size(); i-- > 0;) {
    const bool redundant = [&] {
      for (std::size_t j = 0; j < regions.size(); ++j) {
        if (j != i && contains(regions[j], regions[i])) return true;
      }
      return false;
    }();
    if (redundant) regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// A search over cells and the regions of the screen through which each is seen.  A straight ray
/// crosses a portal's plane once, so a portal is passed only away from the eye.  A region that lies
/// in one already searched for the same cell leads to nothing new; loops end there.
class Search {
 public:
  Search(const CellGraph& graph, const View& view, const ShowAsImage& show_as_image)
      : graph_(graph),
        view_(view),
        show_as_image_(show_as_image),
        cells_(graph.cells.size()),
        sides_(2 * graph.portals.size()),
        outlooks_(graph.portals.size()) {}

  void enter(CellId cell, ScreenRegion region) {
    CellSeen& seen = cells_[cell];
    if (region.empty() || isSearched(seen.regions, region)) return;
    if (seen.regions.size() >= kMostRegions) {
      seen.regions.push_back(std::move(region));
      region = seen.merged ? wholeScreen(view_) : boundingRegion(view_, seen.regions);
      seen.regions.clear();
      seen.merged = true;
    }
    seen.regions.push_back(region);
    pending_.push_back({cell, std::move(region)});
  }

  void run() {
    for (std::size_t next = 0; next < pending_.size(); ++next) {
      const Visit visit = std::move(pending_[next]);
      for (const PortalId portal : graph_.cells[visit.cell].portals) look(visit, portal);
    }
  }

  VisibleSet result(CellId eye_cell) {
    VisibleSet set;
    set.eye_cell = eye_cell;
    for (CellId cell = 0; cell < cells_.size(); ++cell) {
      if (cells_[cell].regions.empty()) continue;
      dropContained(cells_[cell].regions);
      set.cells.push_back({cell, std::move(cells_[cell].regions)});
    }
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      VisiblePortal& side = sides_[i];
      if (side.regions.empty()) continue;
      dropContained(side.regions);
      side.portal = static_cast<PortalId>(i / 2);
      side.from_front = i % 2 == 0;
      set.portals.push_back(std::move(side));
    }
    return set;
  }

  /// How a portal looks from the eye, whatever the region.
  struct Outlook {
    float distance = 0;  // [m] of the eye from the plane, positive in front
    bool near = false;   // the eye is in it, or as good as
    ScreenClip clip;
  };

  const Outlook& outlook(PortalId id) {
    std::optional<Outlook>& known = outlooks_[id];
    if (known) return *known;
    const Portal& portal = graph_.portals[id];
    known.emplace();
    known->distance = portal.plane.signedDistance(view_.eye);
    known->near = std::abs(known->distance) <= kNearPortal &&
                  distanceInPlane(portal.polygon, portal.plane, view_.eye) <= kNearPortal;
    if (!known->near) {
      known->clip = screenClip(view_, grownPolygon(portal.polygon, portal.plane, kPortalMargin));
    }
    return *known;
  }

 private:
  struct CellSeen {
    std::vector<ScreenRegion> regions;
    bool merged = false;
  };
  struct Visit {
    CellId cell;
    ScreenRegion region;
  };

  static bool isSearched(const std::vector<ScreenRegion>& searched, const ScreenRegion& region) {
    return std::any_of(searched.begin(), searched.end(),
                       [&](const ScreenRegion& other) { return contains(other, region); });
  }

  bool isClosed(const Portal& portal) const {
    return !portal.active &&
           !(distanceToPolygon(portal.polygon, portal.plane, view_.eye) < portal.seen_within);
  }

  void look(const Visit& visit, PortalId id) {
    const Portal& portal = graph_.portals[id];
    const bool from_front = portal.front == visit.cell;
    if ((!from_front && !portal.two_way) || isClosed(portal)) return;
    const Outlook& eye = outlook(id);
    if (!eye.near && (from_front ? eye.distance : -eye.distance) < -kPlaneTolerance) return;
    ScreenRegion region = eye.near ? visit.region : clipRegion(view_, visit.region, eye.clip);
    if (region.empty()) return;

    VisiblePortal& side = sides_[2 * id + (from_front ? 0 : 1)];
    side.as_image = !eye.near && show_as_image_ && show_as_image_(portal, id, from_front);
    if (!isSearched(side.regions, region)) side.regions.push_back(region);
    if (!side.as_image) enter(portal.cellBehind(from_front), std::move(region));
  }

  const CellGraph& graph_;
  const View& view_;
  const ShowAsImage& show_as_image_;
  std::vector<CellSeen> cells_;
  std::vector<VisiblePortal> sides_;  // two a portal, front first
  std::vector<std::optional<Outlook>> outlooks_;
  std::vector<Visit> pending_;
};

}  // namespace

VisibleSet cullByPortals(const CellGraph& graph, const View& view, CellId eye_cell,
                         const ShowAsImage& show_as_image) {
  assert(eye_cell < graph.cells.size());
  Search search(graph, view, show_as_image);
  search.enter(eye_cell, wholeScreen(view));
  search.run();
  return search.result(eye_cell);
}

VisibleSet cullBehindPortal(const CellGraph& graph, const View& view, PortalId portal,
                            bool from_front) {
  assert(portal < graph.portals.size());
  const ShowAsImage never;
  Search search(graph, view, never);
  const auto& eye = search.outlook(portal);
  const ScreenRegion screen = wholeScreen(view);
  search.enter(graph.portals[portal].cellBehind(from_front),
               eye.near ? screen : clipRegion(view, screen, eye.clip));
  search.run();
  return search.result(kNoCell);
}

}  // namespace enfilade
