#pragma once

#include <glm/glm.hpp>
#include <string>

#include "portals/cell_graph.h"

namespace enfilade::testing {

/// An upright rectangle across the z axis, from (x0, y0) to (x1, y1), front at +z.
inline Portal portalAcrossZ(float z, float x0, float y0, float x1, float y1, CellId front,
                            CellId back) {
  Portal portal;
  portal.polygon = {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
  portal.plane = planeOf(portal.polygon);
  portal.front = front;
  portal.back = back;
  return portal;
}

/// An upright rectangle across the x axis, front at +x.
inline Portal portalAcrossX(float x, float z0, float y0, float z1, float y1, CellId front,
                            CellId back) {
  Portal portal;
  portal.polygon = {{x, y0, z1}, {x, y0, z0}, {x, y1, z0}, {x, y1, z1}};
  portal.plane = planeOf(portal.polygon);
  portal.front = front;
  portal.back = back;
  return portal;
}

inline CellGraph graphOf(std::size_t cells, std::vector<Portal> portals) {
  CellGraph graph;
  graph.storeys.push_back({"ground", 0});
  graph.cells.resize(cells);
  graph.portals = std::move(portals);
  linkCells(graph);
  return graph;
}

/// Rooms 1…count in a row along −z, 4 deep each, from z = 0; a door 1 wide and 2 high from one into
/// the next, its middle at the origin.  Room 1 is the nearest.
inline CellGraph roomRow(CellId count) {
  std::vector<Portal> doors;
  for (CellId room = 1; room < count; ++room) {
    doors.push_back(
        portalAcrossZ(-4.0f * static_cast<float>(room), -0.5f, -1, 0.5f, 1, room, room + 1));
  }
  return graphOf(count + 1, std::move(doors));
}

}  // namespace enfilade::testing
