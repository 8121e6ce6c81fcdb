// Watertight rooms, true portals, free doorways: brute force on the gallery with few triangles.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>

#include "tests/models/edge_balance.h"
#include "tests/models/test_geometry.h"

namespace enfilade {
namespace {

const Building& gallery() {
  static const Building building = unpaintedGallery(50'000);
  return building;
}

const std::vector<NamedPortal>& portals() {
  static const std::vector<NamedPortal> all = namedPortals(gallery());
  return all;
}

glm::dvec3 normalOf(const NamedPortal& p) {
  return glm::normalize(
      glm::cross(glm::dvec3(p.corners[1] - p.corners[0]), glm::dvec3(p.corners[3] - p.corners[0])));
}

glm::dvec3 middleOf(const NamedPortal& p) { return 0.5 * glm::dvec3(p.corners[0] + p.corners[2]); }

TEST(RaisedRoom, IsClosedByItsWallsFloorCeilingRevealsAndPortalsExactly) {
  for (const Node& node : gallery().nodes) {
    if (!node.name.ends_with("-room")) continue;
    const std::string room = node.name.substr(0, node.name.size() - 5);
    EXPECT_GT(expectClosed(gallery(), portals(), room), 50u);
  }
}

TEST(RaisedOutside, IsClosedButForItsFootInTheGround) {
  EdgeBalance edges;
  const auto shell = worldTriangles(gallery(), [&](const Object& object) {
    const std::string& name = gallery().nodes[object.node].name;
    return name == "facade" || name == "facade-reveals" || name == "coping" || name == "roof";
  });
  for (const WorldTriangle& t : shell) edges.add(t);
  edges.addPortals(portals(), "exterior");
  for (const auto& [a, b] : edges.open()) {
    EXPECT_LT(a.y, -0.2f);
    EXPECT_LT(b.y, -0.2f);
  }
}

TEST(Portals, AreUprightConvexQuadsThatFaceTheirRoom) {
  std::map<std::string, glm::vec3> middles;
  for (const Object& object : gallery().objects) {
    const std::string& name = gallery().nodes[object.node].name;
    if (name.ends_with("-bound"))
      middles[rootName(gallery(), object)] = worldBounds(gallery(), object).center();
  }
  ASSERT_GE(portals().size(), 30u);
  for (const NamedPortal& p : portals()) {
    const glm::dvec3 n = normalOf(p);
    EXPECT_NEAR(n.y, 0, 1e-6) << p.name;
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 a(p.corners[i]), b(p.corners[(i + 1) % 4]), c(p.corners[(i + 2) % 4]);
      EXPECT_GT(glm::dot(glm::cross(b - a, c - b), n), 0) << p.name;
      EXPECT_NEAR(glm::dot(b - a, n), 0, 1e-5) << p.name;
    }
    EXPECT_GT(glm::dot(glm::dvec3(middles.at(p.room)) - middleOf(p), n), 0.3) << p.name;
  }
}

TEST(Portals, AreNamedAfterWhereTheyLead) {
  for (const NamedPortal& p : portals()) {
    EXPECT_TRUE(p.name.starts_with(p.to + "-portal")) << p.name;
    EXPECT_TRUE(p.kind == "door" || p.kind == "window" || p.kind == "opening") << p.kind;
    EXPECT_NE(p.room, p.to + "-room");
  }
}

TEST(Portals, OfDoorsAndOpeningsAreFreeToWalkThrough) {
  const auto all =
      worldTriangles(gallery(), [](const Object& o) { return !isMarker(gallery(), o); });
  for (const NamedPortal& p : portals()) {
    if (p.kind == "window") continue;
    const glm::dvec3 n = normalOf(p), across = glm::dvec3(p.corners[1] - p.corners[0]),
                     up = glm::dvec3(p.corners[3] - p.corners[0]);
    for (const double s : {0.03, 0.25, 0.5, 0.75, 0.97}) {
      for (const double y : {0.03, 0.2, 0.5, 0.8, 0.97}) {
        const glm::dvec3 from = glm::dvec3(p.corners[0]) + s * across + y * up + 0.9 * n;
        for (const WorldTriangle& t : all) {
          const double d = rayMeets(from, -n, t);
          ASSERT_FALSE(d > 0 && d < 1.8) << p.room << " " << p.name << " is blocked by "
                                         << gallery().nodes[gallery().objects[t.object].node].name;
        }
      }
    }
  }
}

bool crosses(const NamedPortal& p, const glm::dvec3& from, const glm::dvec3& d, double within) {
  for (const auto& [i, j, k] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
    const double t = rayMeets(from, d, {p.corners[i], p.corners[j], p.corners[k], 0});
    if (t > 0 && t < within) return true;
  }
  return false;
}

TEST(RaisedRoom, KeepsEverySightLineThatCrossesNoPortal) {
  const auto all =
      worldTriangles(gallery(), [](const Object& o) { return !isMarker(gallery(), o); });
  for (const Object& bound : gallery().objects) {
    if (!gallery().nodes[bound.node].name.ends_with("-bound")) continue;
    const std::string room = rootName(gallery(), bound);
    const glm::dvec3 eye =
        glm::dvec3(worldBounds(gallery(), bound).center()) + glm::dvec3(0.13, 0.4, 0.21);
    for (int i = 0; i < 60; ++i) {
      // Directions spread evenly over the sphere.
      const double y = 1 - 2 * (i + 0.5) / 60, a = 2.399963 * i, r = std::sqrt(1 - y * y);
      const glm::dvec3 d(r * std::cos(a), y, r * std::sin(a));
      double nearest = 1e30;
      std::uint32_t object = kNone;
      for (const WorldTriangle& t : all) {
        const double distance = rayMeets(eye, d, t);
        if (distance > 0 && distance < nearest) {
          nearest = distance;
          object = t.object;
        }
      }
      bool through = false;
      for (const NamedPortal& p : portals())
        through |= (p.room == room || p.to + "-room" == room) && crosses(p, eye, d, nearest);
      if (through) continue;
      ASSERT_NE(object, kNone) << room;
      EXPECT_EQ(rootName(gallery(), gallery().objects[object]), room);
    }
  }
}

}  // namespace
}  // namespace enfilade
