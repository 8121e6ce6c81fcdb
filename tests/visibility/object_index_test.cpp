#include "visibility/object_index.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "box_house.h"
#include "test_views.h"

namespace enfilade {
namespace {

using namespace enfilade::testing;

/// Small triangles all over a house of boxes, each in the cell of its first corner and in that of
/// its last one; every seventh is a door.
House houseWithObjects(const BoxHouse& boxes, std::mt19937& random, int count) {
  House house;
  house.graph = boxes.graph();
  house.building.materials.resize(1);
  for (int i = 0; i < count; ++i) {
    glm::vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = uniform(random, static_cast<float>(boxes.least()[axis]) - 2,
                        static_cast<float>(boxes.most()[axis]) + 2);
    }
    const auto id = static_cast<std::uint32_t>(i);
    const glm::vec3 q = p + glm::vec3(uniform(random, 0, 0.5f));
    house.building.vertex_arrays.push_back({{p, q, p + glm::vec3(0, 0, 0.1f)}, {}, {}, {}});
    house.building.meshes.push_back({"", id, 0, {0, 1, 2}, {}});
    house.building.nodes.emplace_back();
    house.building.objects.push_back({id, id});
    house.object_roles.push_back(i % 7 == 0 ? ObjectRole::kDoor : ObjectRole::kFixed);
    std::vector<CellId> cells = {boxes.cellAt(p), boxes.cellAt(q)};
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    house.object_cells.push_back(cells);
  }
  return house;
}

bool increases(const std::vector<std::uint32_t>& objects) {
  return std::adjacent_find(objects.begin(), objects.end(), std::greater_equal<>()) ==
         objects.end();
}

TEST(ObjectIndex, ListsEachCellsObjectsButDoorsThatShutNothing) {
  std::mt19937 random(1);
  const BoxHouse boxes(1, {});
  const House house = houseWithObjects(boxes, random, 300);
  const ObjectIndex index(house);
  const std::vector<DoorLeaf> leaves = doorLeaves(house);
  for (CellId cell = 0; cell < house.graph.cells.size(); ++cell) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < 300; ++i) {
      const auto& cells = house.object_cells[i];
      bool seen = i % 7 != 0 && std::count(cells.begin(), cells.end(), cell) > 0;
      for (const DoorLeaf& leaf : leaves) {
        const Portal& portal = house.graph.portals[leaf.portal];
        const bool beside = portal.front == cell || portal.back == cell;
        seen |= leaf.object == i && (beside || std::count(cells.begin(), cells.end(), cell) > 0);
      }
      if (seen) expected.push_back(i);
    }
    EXPECT_TRUE(std::ranges::equal(index.ofCell(cell), expected));
  }
  EXPECT_EQ(index.bounds().size(), 300u);
  EXPECT_EQ(index.bounds()[7].min, worldBounds(house.building, house.building.objects[7]).min);
}

TEST(ObjectIndex, VisibleAreJustTheObjectsOfVisibleCellsInTheirRegions) {
  std::mt19937 random(2);
  std::size_t drawn = 0;
  std::size_t culled = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const BoxHouse boxes(seed, {});
    const House house = houseWithObjects(boxes, random, 400);
    const ObjectIndex index(house);
    for (int v = 0; v < 10; ++v) {
      const View view =
          randomView(random, house.building.vertex_arrays[random() % 400].positions[0]);
      const VisibleSet set = cullByPortals(house.graph, view, boxes.cellAt(view.eye));
      const std::vector<std::uint32_t> objects = index.visible(set);
      EXPECT_TRUE(increases(objects));
      std::vector<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < 400; ++i) {
        const auto& in = house.object_cells[i];
        const bool seen = std::any_of(set.cells.begin(), set.cells.end(), [&](const auto& cell) {
          return std::count(in.begin(), in.end(), cell.cell) > 0 &&
                 std::any_of(cell.regions.begin(), cell.regions.end(), [&](const auto& region) {
                   return mayBeSeen(region, index.bounds()[i]);
                 });
        });
        if (seen && house.object_roles[i] != ObjectRole::kDoor) expected.push_back(i);
      }
      EXPECT_EQ(objects, expected);
      // What is in plain sight of the eye is among them.
      for (std::uint32_t i = 0; i < 400; ++i) {
        const glm::vec3& p = house.building.vertex_arrays[i].positions[0];
        if (i % 7 == 0 || !onScreen(view, p) || !boxes.sees(view.eye, p)) continue;
        EXPECT_TRUE(std::binary_search(objects.begin(), objects.end(), i));
      }
      drawn += objects.size();
      culled +=
          index.inFrustum(view).size() - std::min(index.inFrustum(view).size(), objects.size());
    }
  }
  EXPECT_GT(drawn, 500u);
  EXPECT_GT(culled, 500u);
}

TEST(ObjectIndex, AListAskedAgainHoldsTheNewAnswerInTheSameMemory) {
  std::mt19937 random(4);
  const BoxHouse boxes(4, {});
  const House house = houseWithObjects(boxes, random, 300);
  const ObjectIndex index(house);
  ObjectList list;
  const std::uint32_t* memory = nullptr;
  for (int v = 0; v < 20; ++v) {
    const View view = randomView(random, house.building.vertex_arrays[random() % 300].positions[0]);
    const VisibleSet set = cullByPortals(house.graph, view, boxes.cellAt(view.eye));
    index.inFrustum(view, list);
    EXPECT_EQ(list.objects, index.inFrustum(view));
    index.visible(set, list);
    EXPECT_EQ(list.objects, index.visible(set));
    EXPECT_TRUE(v == 0 || list.objects.data() == memory);
    memory = list.objects.data();
  }
}

TEST(ObjectIndex, InFrustumLosesNothingInViewAndLeavesOutWhatIsFarOff) {
  std::mt19937 random(3);
  const BoxHouse boxes(3, {});
  const House house = houseWithObjects(boxes, random, 500);
  const ObjectIndex index(house);
  std::size_t out = 0;
  for (int v = 0; v < 50; ++v) {
    const View view = randomView(random, house.building.vertex_arrays[random() % 500].positions[0]);
    const std::vector<std::uint32_t> objects = index.inFrustum(view);
    EXPECT_TRUE(increases(objects));
    for (std::uint32_t i = 0; i < 500; ++i) {
      const bool in = std::binary_search(objects.begin(), objects.end(), i);
      if (i % 7 == 0) {
        EXPECT_FALSE(in);
        continue;
      }
      out += !in;
      for (const glm::vec3& p : house.building.vertex_arrays[i].positions) {
        const glm::dvec4 clip = glm::dmat4(view.clip_from_world) * glm::dvec4(p, 1);
        const bool shown = clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w &&
                           std::abs(clip.z) <= clip.w;
        EXPECT_TRUE(in || !shown);
      }
    }
  }
  EXPECT_GT(out, 50u * 100u);
}

}  // namespace
}  // namespace enfilade
