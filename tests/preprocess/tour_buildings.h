#pragma once

#include "tour_houses.h"

namespace enfilade::testing {

/// Four rooms of 3 × 3 m about a cross of walls, a door in each of its arms.
HouseBuilder ringOfRooms();

/// Two rooms of 7 × 4 m above each other, a stair of 16 risers along the wall z = 0.
HouseBuilder twoStoreys();

/// A room of 4 × 4 m on a lawn, its door in the wall x = 0.
HouseBuilder cottage();

}  // namespace enfilade::testing
