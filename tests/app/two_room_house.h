#pragma once

#include "ibr/image_parameters.h"
#include "portals/house.h"

namespace enfilade {

/// Two furnished rooms of 4 × 4 × 2.6 m with a doorway between; every object is seen from both.
House twoRoomHouse();

/// The same with every box in a colour of its own; images are shown beyond 0.4 m, nearer than any
/// viewpoint.
House colouredTwoRooms();

/// Few and small images of every kind, as colouredTwoRooms() has them in its parameters.
ImageParameters parametersForAllImages();

}  // namespace enfilade
