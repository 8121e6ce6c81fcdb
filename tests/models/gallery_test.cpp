// The sample building as a whole: what it promises to those who preprocess and draw it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "models/samples.h"
#include "scene/error.h"
#include "scene/gltf_writer.h"
#include "tests/models/test_geometry.h"

namespace enfilade {
namespace {

const Building& smallGallery() {
  static const Building building = unpaintedGallery(50'000);
  return building;
}

std::size_t drawnTriangles(const Building& building) {
  std::size_t count = 0;
  for (const Object& object : building.objects)
    if (!isMarker(building, object)) count += building.meshOf(object).indices.size() / 3;
  return count;
}

TEST(Gallery, HasAboutAsManyTrianglesAsAskedFor) {
  for (const std::uint64_t wanted : {50'000u, 150'000u, 1'000'000u}) {
    const double off = 0.02 * static_cast<double>(wanted);
    const Building building = unpaintedGallery(wanted);
    EXPECT_NEAR(static_cast<double>(triangleCount(building)), static_cast<double>(wanted), off);
    EXPECT_NEAR(static_cast<double>(drawnTriangles(building)), static_cast<double>(wanted), off);
  }
}

TEST(Gallery, HasNineRoomsEachWithWallsPortalsAndABound) {
  const Building& building = smallGallery();
  std::map<std::string, std::set<std::string>> rooms;
  for (const Node& node : building.nodes)
    if (node.name.ends_with("-room")) rooms[node.name];
  EXPECT_EQ(rooms.size(), 9u);
  for (const Node& node : building.nodes)
    if (node.parent != kNone && rooms.contains(building.nodes[node.parent].name))
      rooms[building.nodes[node.parent].name].insert(node.name);
  for (const auto& [room, children] : rooms) {
    const std::string name = room.substr(0, room.size() - 5);
    for (const char* part : {"-walls", "-floor", "-ceiling", "-bound"})
      EXPECT_TRUE(children.contains(name + part)) << name << part;
  }
}

TEST(Gallery, SharesTheMeshesOfWhatStandsInManyPlaces) {
  const Building& building = smallGallery();
  std::map<std::uint32_t, int> places;
  for (const Object& object : building.objects) ++places[object.mesh];
  int shared = 0;
  for (const auto& [mesh, count] : places) shared += count > 1;
  EXPECT_GT(shared, 20);
}

TEST(Gallery, HasOnlyFiniteVerticesAndUnitNormals) {
  for (const VertexArrays& arrays : smallGallery().vertex_arrays) {
    ASSERT_EQ(arrays.normals.size(), arrays.positions.size());
    ASSERT_EQ(arrays.texcoords.size(), arrays.positions.size());
    ASSERT_EQ(arrays.colors.size(), arrays.positions.size());
    for (std::size_t i = 0; i < arrays.positions.size(); ++i) {
      ASSERT_TRUE(glm::all(glm::lessThan(glm::abs(arrays.positions[i]), glm::vec3(1000))));
      ASSERT_NEAR(glm::length(arrays.normals[i]), 1, 1e-4);
      ASSERT_TRUE(glm::all(glm::lessThan(glm::abs(arrays.texcoords[i]), glm::vec2(1000))));
    }
  }
}

TEST(Gallery, HasNoDegenerateTriangles) {
  for (const std::uint64_t wanted : {50'000u, 400'000u}) {
    const Building building = unpaintedGallery(wanted);
    for (const Mesh& mesh : building.meshes) {
      const auto& p = building.vertex_arrays[mesh.vertices].positions;
      for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(p[mesh.indices[i]]), b(p[mesh.indices[i + 1]]),
            c(p[mesh.indices[i + 2]]);
        ASSERT_GT(glm::length(glm::cross(b - a, c - a)), 1e-12) << mesh.name << " " << i / 3;
      }
    }
  }
}

TEST(Gallery, IsTheSameBytesEveryTime) {
  EXPECT_EQ(encodeGlb(raiseSample("gallery", 50'000)), encodeGlb(raiseSample("gallery", 50'000)));
}

TEST(Gallery, IsPaintedUnlessToldOtherwise) {
  const Building building = raiseSample("gallery");
  EXPECT_NEAR(static_cast<double>(triangleCount(building)), 150'000, 3'000);
  ASSERT_GT(building.images.size(), 40u);
  for (const TextureImage& texture : building.images) {
    const auto& rgba = texture.image.rgba;
    std::set<int> greens;
    for (std::size_t i = 1; i < rgba.size(); i += 4) greens.insert(rgba[i]);
    EXPECT_GT(greens.size(), 8u) << texture.name;
  }
}

TEST(Samples, NameTheGallery) {
  const auto names = sampleNames();
  EXPECT_NE(std::find(names.begin(), names.end(), "gallery"), names.end());
}

TEST(Samples, ListWhatThereIsWhenANameIsUnknown) {
  try {
    raiseSample("castle");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::kUsage);
    EXPECT_NE(std::string(e.what()).find("gallery"), std::string::npos) << e.what();
  }
}

TEST(Samples, RejectTooFewAndTooManyTriangles) {
  EXPECT_THROW(raiseSample("gallery", 49'999), Error);
  EXPECT_THROW(raiseSample("gallery", 10'000'001), Error);
}

}  // namespace
}  // namespace enfilade
