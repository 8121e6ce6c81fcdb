// Portal culling against houses of boxes, in which what is seen is known.

#include <gtest/gtest.h>

#include <algorithm>

#include "box_house.h"
#include "test_views.h"
#include "visibility/portal_culling.h"
#include "visibility/portal_walk.h"

namespace enfilade {
namespace {

using namespace enfilade::testing;

bool isSeen(const VisibleSet& set, CellId cell, const glm::dvec2& at, const glm::vec3& p) {
  const auto seen = std::find_if(set.cells.begin(), set.cells.end(),
                                 [&](const VisibleCell& c) { return c.cell == cell; });
  return seen != set.cells.end() &&
         std::any_of(seen->regions.begin(), seen->regions.end(), [&](const ScreenRegion& region) {
           return depthInside(region, at) >= 0 && mayBeSeen(region, Box{p, p});
         });
}

struct Tally {
  int seen = 0;
  int seen_elsewhere = 0;  // in another cell than the eye's
  int lost = 0;
};

/// Every point in view that nothing hides must lie in a region of its cell.
void check(const BoxHouse& house, const View& view, std::mt19937& random, int points,
           Tally& tally) {
  const CellId eye_cell = house.cellAt(view.eye);
  const VisibleSet set = cullByPortals(house.graph(), view, eye_cell);
  for (int i = 0; i < points; ++i) {
    const glm::vec3 p = randomPoint(random, house, 3);
    const auto at = onScreen(view, p);
    if (!at || !house.sees(view.eye, p)) continue;
    const CellId cell = house.cellAt(p);
    ++tally.seen;
    tally.seen_elsewhere += cell != eye_cell;
    if (isSeen(set, cell, *at, p)) continue;
    ++tally.lost;
    ADD_FAILURE() << "lost a point of cell " << cell << " seen from cell " << eye_cell;
  }
}

TEST(PortalCullingOracle, NothingThatIsSeenIsCulled) {
  Tally tally;
  std::mt19937 random(1);
  for (unsigned seed = 0; seed < 40; ++seed) {
    const BoxHouse house(seed, {});
    for (int view = 0; view < 25 && tally.lost < 10; ++view) {
      check(house, randomView(random, randomPoint(random, house, 2)), random, 4000, tally);
    }
  }
  EXPECT_GT(tally.seen_elsewhere, 4000);
}

TEST(PortalCullingOracle, NothingThatIsSeenFromWithinOpeningsIsCulled) {
  Tally tally;
  std::mt19937 random(2);
  for (unsigned seed = 100; seed < 140; ++seed) {
    const BoxHouse house(seed, {});
    for (int view = 0; view < 25 && tally.lost < 10; ++view) {
      check(house, randomView(random, pointAtAnOpening(random, house)), random, 4000, tally);
    }
  }
  EXPECT_GT(tally.seen_elsewhere, 4000);
}

TEST(PortalCullingOracle, LoopsAndManyPathsEnd) {
  BoxHouse::Options options;
  options.rooms = {7, 3, 7};
  options.door_chance = 1;
  options.missing_chance = 0;
  Tally tally;
  std::mt19937 random(3);
  for (unsigned seed = 0; seed < 3; ++seed) {
    const BoxHouse house(seed, options);
    for (int view = 0; view < 10 && tally.lost < 10; ++view) {
      check(house, randomView(random, randomPoint(random, house, 0)), random, 40000, tally);
    }
  }
  EXPECT_GT(tally.seen_elsewhere, 500);
}

TEST(PortalCullingOracle, RegionsAreNoLargerThanWhatIsSeen) {
  // In convex rooms a ray through the middle of any region gets to its cell.
  BoxHouse::Options options;
  options.missing_chance = 0;
  options.court_chance = 0;
  int regions = 0;
  std::mt19937 random(4);
  std::vector<PortalCrossing> crossings;
  for (unsigned seed = 0; seed < 30; ++seed) {
    const BoxHouse house(seed, options);
    const PortalWalker walker(house.graph(), 0.01f);
    for (int v = 0; v < 30; ++v) {
      const View view = randomView(random, randomPoint(random, house, 0));
      const CellId eye_cell = house.cellAt(view.eye);
      const VisibleSet set = cullByPortals(house.graph(), view, eye_cell);
      const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(view.clip_from_world));
      for (const VisibleCell& cell : set.cells) {
        for (const ScreenRegion& region : cell.regions) {
          glm::dvec2 middle(0);
          for (const glm::vec2& corner : region.corners) middle += glm::dvec2(corner);
          middle /= static_cast<double>(region.corners.size());
          if (depthInside(region, middle) < 0.03) continue;
          const glm::dvec4 far = world_from_clip * glm::dvec4(middle, 1, 1);
          const glm::vec3 direction =
              glm::vec3(glm::normalize(glm::dvec3(far) / far.w - glm::dvec3(view.eye)));
          walker.walk(eye_cell, view.eye, direction, 1e6f, crossings);
          bool met = cell.cell == eye_cell;
          for (const PortalCrossing& crossing : crossings) {
            met = met || house.graph().portals[crossing.portal].cellBehind(crossing.from_front) ==
                             cell.cell;
          }
          bool near = false;  // an eye as good as in a portal sees more than it should
          for (const auto& [least, most] : house.openings()) {
            near = near || glm::distance(glm::dvec3(view.eye),
                                         glm::clamp(glm::dvec3(view.eye), least, most)) < 0.25;
          }
          regions += cell.cell != eye_cell;
          EXPECT_TRUE(met || near) << "cell " << cell.cell << " from " << eye_cell;
        }
      }
    }
  }
  EXPECT_GT(regions, 500);
}

TEST(PortalCullingOracle, BehindAPortalIsWhatIsSeenThroughIt) {
  std::mt19937 random(5);
  int seen = 0;
  int lost = 0;
  for (unsigned seed = 200; seed < 230; ++seed) {
    const BoxHouse house(seed, {});
    const CellGraph& graph = house.graph();
    const PortalWalker walker(graph, 0);
    std::vector<PortalCrossing> crossings;
    for (int v = 0; v < 30; ++v) {
      const auto id = static_cast<PortalId>(random() % graph.portals.size());
      const Portal& portal = graph.portals[id];
      const View view = randomView(random, randomPoint(random, house, 2));
      const bool from_front = portal.plane.signedDistance(view.eye) > 0;
      const VisibleSet set = cullBehindPortal(graph, view, id, from_front);
      EXPECT_EQ(set.eye_cell, kNoCell);
      for (int i = 0; i < 8000; ++i) {
        // A point is seen through the portal if its way to where it meets the portal is free,
        // wherever the eye may be.
        const glm::vec3 p = randomPoint(random, house, 3);
        const auto at = onScreen(view, p);
        const float eye_side = portal.plane.signedDistance(view.eye);
        const float point_side = portal.plane.signedDistance(p);
        if (!at || eye_side * point_side >= 0) continue;
        const glm::dvec3 hit = glm::mix(glm::dvec3(view.eye), glm::dvec3(p),
                                        double(eye_side) / (double(eye_side) - point_side));
        const glm::dvec3 beyond = glm::mix(hit, glm::dvec3(p), 1e-4);
        glm::vec3 least = glm::min(portal.polygon[0], portal.polygon[2]) - 1e-5f;
        glm::vec3 most = glm::max(portal.polygon[0], portal.polygon[2]) + 1e-5f;
        if (!Box{least, most}.contains(glm::vec3(hit)) || !house.sees(beyond, p)) continue;
        ++seen;
        if (lost < 10 && !isSeen(set, house.cellAt(p), *at, p)) {
          ++lost;
          ADD_FAILURE() << "lost a point of cell " << house.cellAt(p) << " behind portal " << id;
        }
      }
    }
  }
  EXPECT_GT(seen, 1000);
}

}  // namespace
}  // namespace enfilade
