#include "portals/given_graph.h"
#include "portals/grid_file.h"
#include "portals/house_json.h"
#include "tests/fuzz/containers.h"
#include "tests/fuzz/soundness.h"

namespace enfilade::fuzz {

void house_json(Bytes input) {
  House house;
  decodeHouseJson(sealHouseJson(textOf(input)), "house.json", house);
  requireSound(house.graph);
  require(house.object_cells.size() == house.object_roles.size(), "cells for each object");
  for (const std::vector<CellId>& cells : house.object_cells) {
    for (const CellId cell : cells) require(cell < house.graph.cells.size(), "an object's cells");
  }
  require(house.switch_distance > 0 && house.eye_height > 0, "distances above 0");
}

void given_graph(Bytes input) {
  const GivenGraph given = decodeGivenGraph(input, "house.json");
  requireSound(given.graph);
  require(given.labels.size() == given.graph.cells.size(), "a label for each cell");
}

void grid(Bytes input) {
  const CellGrid cells = decodeGrid(sealGrid(input), "cells.grid");
  const glm::ivec3 size = cells.size();
  require(cells.voxel() > 0 && cells.firstRuns().back() == cells.runs().size(), "a whole grid");
  for (const int x : {0, size.x / 2, size.x - 1}) {
    for (const int z : {0, size.z / 2, size.z - 1}) {
      require(cells.column(x, z).back().end_y == size.y, "runs to the top");
      for (const int y : {-1, 0, size.y - 1, size.y}) cells.labelAt({x, y, z});
    }
  }
}

}  // namespace enfilade::fuzz
