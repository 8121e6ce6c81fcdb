#include "tour_buildings.h"

namespace enfilade::testing {

HouseBuilder ringOfRooms() {
  HouseBuilder b;
  b.slabs({-0.2f, 0, -0.2f}, {6.4f, 2.6f, 6.4f});
  b.solid({-0.2f, 0, -0.2f}, {0, 2.6f, 6.4f});
  b.solid({6.2f, 0, -0.2f}, {6.4f, 2.6f, 6.4f});
  b.solid({0, 0, -0.2f}, {6.2f, 2.6f, 0});
  b.solid({0, 0, 6.2f}, {6.2f, 2.6f, 6.4f});
  b.wallWithHole({3, 0, 0}, {3.2f, 2.6f, 3}, 1, 1.9f, 0, 2.1f);
  b.wallWithHole({3, 0, 3}, {3.2f, 2.6f, 6.2f}, 4.3f, 5.2f, 0, 2.1f);
  for (const float x : {0.0f, 3.2f}) {
    b.solid({x, 0, 3}, {x + 1, 2.6f, 3.2f});
    b.solid({x + 1.9f, 0, 3}, {x + 3, 2.6f, 3.2f});
    b.solid({x + 1, 2.1f, 3}, {x + 1.9f, 2.6f, 3.2f});
  }
  const CellId sw = b.cell("sw", {0, 0, 0}, {3, 2.6f, 3});
  const CellId se = b.cell("se", {3.2f, 0, 0}, {6.2f, 2.6f, 3});
  const CellId nw = b.cell("nw", {0, 0, 3.2f}, {3, 2.6f, 6.2f});
  const CellId ne = b.cell("ne", {3.2f, 0, 3.2f}, {6.2f, 2.6f, 6.2f});
  b.portal(se, sw, PortalKind::kDoor, {3.1f, 0, 1}, {3.1f, 2.1f, 1.9f});
  b.portal(ne, nw, PortalKind::kDoor, {3.1f, 0, 4.3f}, {3.1f, 2.1f, 5.2f});
  b.portal(nw, sw, PortalKind::kDoor, {1, 0, 3.1f}, {1.9f, 2.1f, 3.1f});
  b.portal(ne, se, PortalKind::kDoor, {4.2f, 0, 3.1f}, {5.1f, 2.1f, 3.1f});
  return b;
}

HouseBuilder twoStoreys() {
  HouseBuilder b;
  b.solid({-0.2f, -0.2f, -0.2f}, {7.2f, 0, 4.2f});
  b.solid({-0.2f, 5.4f, -0.2f}, {7.2f, 5.6f, 4.2f});
  b.solid({-0.2f, 0, -0.2f}, {0, 5.4f, 4.2f});
  b.solid({7, 0, -0.2f}, {7.2f, 5.4f, 4.2f});
  b.solid({0, 0, -0.2f}, {7, 5.4f, 0});
  b.solid({0, 0, 4}, {7, 5.4f, 4.2f});
  b.solid({0, 2.6f, 1}, {7, 2.8f, 4});
  b.solid({0, 2.6f, 0}, {1.9f, 2.8f, 1});
  b.solid({5.05f, 2.6f, 0}, {7, 2.8f, 1});
  for (int i = 0; i < 15; ++i) {
    const auto step = static_cast<float>(i);
    b.solid({1 + 0.27f * step, 0, 0}, {1.27f + 0.27f * step, 0.175f * (step + 1), 1});
  }
  b.solid({1.85f, 2.8f, 1}, {5.05f, 3.8f, 1.05f});  // railings
  b.solid({1.85f, 2.8f, 0}, {1.9f, 3.8f, 1});
  const CellId below = b.cell("below", {0, 0, 0}, {7, 2.6f, 4});
  const CellId above = b.cell("above", {0, 2.8f, 0}, {7, 5.4f, 4});
  b.portal(above, below, PortalKind::kOpening, {1.9f, 2.7f, 0}, {5.05f, 2.7f, 1});
  return b;
}

HouseBuilder cottage() {
  HouseBuilder b;
  b.solid({-10, -0.3f, -8}, {12, -0.1f, 12});
  b.slabs({-0.2f, 0, -0.2f}, {4.2f, 2.6f, 4.2f});
  b.wallWithHole({-0.2f, 0, -0.2f}, {0, 2.6f, 4.2f}, 1.5f, 2.4f, 0, 2.1f);
  b.solid({4, 0, -0.2f}, {4.2f, 2.6f, 4.2f});
  b.solid({0, 0, -0.2f}, {4, 2.6f, 0});
  b.solid({0, 0, 4}, {4, 2.6f, 4.2f});
  const CellId room = b.cell("room", {0, 0, 0}, {4, 2.6f, 4});
  b.portal(room, kExterior, PortalKind::kDoor, {-0.1f, 0, 1.5f}, {-0.1f, 2.1f, 2.4f});
  return b;
}

}  // namespace enfilade::testing
