#include "preprocess/bake_light.h"

#include <gtest/gtest.h>

#include "scene/gltf_writer.h"
#include "tests/preprocess/light_room.h"

namespace enfilade {
namespace {

LightRoom litRoom() {
  LightRoom room(0.6f);
  room.box({3, 2.5f, 4});
  room.lamp({1.5f, 2, 2}, 80);
  return room;
}

TEST(BakeLight, MakesMaterialsUnlitAndKeepsTheOrderOfObjects) {
  Building building = litRoom().building;
  const std::vector<Object> before = building.objects;
  const BakedLight baked = bakeLight(building, {}, {}, {});
  EXPECT_GT(baked.exposure, 0);
  ASSERT_EQ(building.objects.size(), before.size());
  for (std::size_t o = 0; o < before.size(); ++o) {
    EXPECT_EQ(building.objects[o].node, before[o].node);
    EXPECT_TRUE(building.materialOf(building.objects[o]).unlit);
    const Mesh& mesh = building.meshOf(building.objects[o]);
    const VertexArrays& vertices = building.vertex_arrays[mesh.vertices];
    EXPECT_EQ(vertices.colors.size(), vertices.positions.size());
    for (const glm::u16vec4& color : vertices.colors) EXPECT_GT(color.g, 0);
  }
}

TEST(BakeLight, ObjectsThatShareAMeshGetColoursOfTheirOwn) {
  LightRoom room = litRoom();
  // The floor once more, far above the room, where no light comes.
  glm::mat4 away(1);
  away[3] = glm::vec4(0, 1, 0, 1);
  room.building.nodes.push_back({"shelf", kNone, away, {}});
  room.building.objects.push_back(
      {static_cast<std::uint32_t>(room.building.nodes.size() - 1), room.building.objects[0].mesh});
  bakeLight(room.building, {}, {}, {});
  const Building& b = room.building;
  const Mesh& floor = b.meshOf(b.objects.front());
  const Mesh& shelf = b.meshOf(b.objects.back());
  EXPECT_EQ(b.vertex_arrays[floor.vertices].positions, b.vertex_arrays[shelf.vertices].positions);
  EXPECT_NE(b.vertex_arrays[floor.vertices].colors, b.vertex_arrays[shelf.vertices].colors);
}

TEST(BakeLight, LeavesWhatIsUnlitAndMultipliesTheTintsThatThereAre) {
  LightRoom plain = litRoom(), tinted = litRoom();
  for (LightRoom* room : {&plain, &tinted}) {
    room->building.materials.push_back(room->building.materials[0]);
    room->building.materials[1].unlit = true;
    room->building.meshes[1].material = 1;
  }
  for (VertexArrays& arrays : tinted.building.vertex_arrays) {
    arrays.colors.assign(arrays.positions.size(), glm::u16vec4(65535, 32768, 0, 65535));
  }
  const std::uint32_t kept = plain.building.objects[1].mesh;
  bakeLight(plain.building, {}, {}, {});
  bakeLight(tinted.building, {}, {}, {});
  EXPECT_EQ(plain.building.objects[1].mesh, kept);
  const Mesh& floor = tinted.building.meshOf(tinted.building.objects[0]);
  for (const glm::u16vec4& color : tinted.building.vertex_arrays[floor.vertices].colors) {
    EXPECT_EQ(color.b, 0);
    EXPECT_GT(color.r, 0);
  }
}

TEST(BakeLight, WithoutAnyLightChangesNoColour) {
  LightRoom room(0.5f);
  room.box({3, 3, 3});
  EXPECT_EQ(bakeLight(room.building, {}, {}, {}).exposure, 0.0f);
  EXPECT_FALSE(room.building.materials[0].unlit);
}

TEST(BakeLight, GivesTheSameBytesForAnyNumberOfThreads) {
  LightParameters parameters;
  Building one = litRoom().building, three = litRoom().building;
  parameters.threads = 1;
  bakeLight(one, {}, {}, parameters);
  parameters.threads = 3;
  bakeLight(three, {}, {}, parameters);
  EXPECT_EQ(encodeGlb(one), encodeGlb(three));
}

TEST(BakeLight, TakesPortalsToTheExteriorForWindowsAndKeepsTheMarkers) {
  LightRoom room(0.6f);
  room.building.nodes.push_back({"study-room", kNone, glm::mat4(1), R"({"cell":"study"})"});
  room.box({3, 2.5f, 4});
  for (std::size_t n = 1; n < room.building.nodes.size(); ++n) room.building.nodes[n].parent = 0;
  // The wall at z = 4 makes way for a portal that fills it.
  room.building.nodes[6].name = "exterior-portal";
  room.building.nodes[6].extras = R"({"portal":{"kind":"window","to":"exterior"}})";
  for (std::size_t o = 0; o < room.building.objects.size(); ++o) {
    room.building.objects[o].node = static_cast<std::uint32_t>(o + 1);
  }
  const std::uint32_t marker = room.building.objects[5].mesh;
  const BakedLight baked = bakeNamedLight(room.building, {});
  EXPECT_GT(baked.exposure, 0);
  ASSERT_EQ(room.building.objects.size(), 6u);
  EXPECT_EQ(room.building.objects[5].mesh, marker);
  EXPECT_NE(room.building.objects[4].mesh, 4u);
}

}  // namespace
}  // namespace enfilade
