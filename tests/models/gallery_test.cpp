#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "models/samples.h"
#include "scene/error.h"
#include "scene/gltf_writer.h"

namespace enfilade {
namespace {

bool isMarker(const Building& building, const Object& object) {
  return building.materialOf(object).name == "marker";
}

std::size_t drawnTriangles(const Building& building) {
  std::size_t count = 0;
  for (const Object& object : building.objects)
    if (!isMarker(building, object)) count += building.meshOf(object).indices.size() / 3;
  return count;
}

TEST(Gallery, HasAboutAsManyTrianglesAsAskedFor) {
  for (const std::uint64_t wanted : {50'000u, 150'000u, 400'000u, 1'000'000u}) {
    const double off = 0.02 * static_cast<double>(wanted);
    const Building building = raiseSample("gallery", wanted);
    EXPECT_NEAR(static_cast<double>(triangleCount(building)), static_cast<double>(wanted), off);
    EXPECT_NEAR(static_cast<double>(drawnTriangles(building)), static_cast<double>(wanted), off);
  }
}

TEST(Gallery, HasNineRoomsWithPortals) {
  const Building building = raiseSample("gallery", 50'000);
  std::set<std::string> rooms;
  std::map<std::string, int> portals;
  for (const Node& node : building.nodes) {
    if (node.name.ends_with("-room")) rooms.insert(node.name);
    if (node.name.find("-portal") != std::string::npos) ++portals[building.nodes[node.parent].name];
  }
  EXPECT_EQ(rooms.size(), 9u);
  for (const auto& [room, count] : portals) EXPECT_TRUE(rooms.contains(room)) << room;
}

TEST(Gallery, IsTheSameBytesEveryTime) {
  EXPECT_EQ(encodeGlb(raiseSample("gallery", 50'000)), encodeGlb(raiseSample("gallery", 50'000)));
}

TEST(Samples, RejectAnUnknownName) { EXPECT_THROW(raiseSample("castle"), Error); }

TEST(Samples, RejectTooFewTriangles) { EXPECT_THROW(raiseSample("gallery", 10), Error); }

}  // namespace
}  // namespace enfilade
