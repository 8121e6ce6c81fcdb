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

}  // namespace enfilade
