#include "tests/app/two_room_house.h"

#include "tests/preprocess/tour_houses.h"

namespace enfilade {

House twoRoomHouse() {
  testing::HouseBuilder builder = testing::twoRooms(1.0f);
  builder.solid({0.3f, 0, 0.3f}, {0.9f, 0.7f, 0.9f});
  builder.solid({7.0f, 0, 3.0f}, {7.8f, 1.2f, 3.6f});
  House house = builder.build();
  std::vector<CellId> all;
  for (CellId cell = 0; cell < house.graph.cells.size(); ++cell) all.push_back(cell);
  house.object_cells.assign(house.building.objects.size(), all);
  return house;
}

ImageParameters parametersForAllImages() {
  ImageParameters parameters;
  parameters.bake = {};
  parameters.image_size = 160;
  parameters.rings = {{5, 75.0f, 0.0f}, {2, 40.0f, -0.4f}};
  parameters.textures = 5;
  return parameters;
}

House colouredTwoRooms() {
  House house = twoRoomHouse();
  Building& building = house.building;
  building.materials.clear();
  for (std::size_t i = 0; i < building.meshes.size(); ++i) {
    const auto share = static_cast<float>(i) / static_cast<float>(building.meshes.size());
    Material material;
    material.unlit = true;
    material.double_sided = true;
    material.base_color = {0.2f + 0.7f * share, 0.9f - 0.6f * share, i % 2 == 0 ? 0.3f : 0.7f, 1};
    building.meshes[i].material = static_cast<std::uint32_t>(building.materials.size());
    building.materials.push_back(material);
  }
  house.switch_distance = 0.4f;
  house.info.parameters = imageParameterTexts(parametersForAllImages());
  return house;
}

}  // namespace enfilade
