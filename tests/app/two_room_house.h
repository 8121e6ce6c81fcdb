#pragma once

#include "portals/house.h"

namespace enfilade {

/// Two furnished rooms of 4 × 4 × 2.6 m with a doorway between; every object is seen from both.
House twoRoomHouse();

}  // namespace enfilade
