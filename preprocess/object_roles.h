#pragma once

#include <string>
#include <vector>

#include "portals/house.h"
#include "preprocess/cut_cells.h"
#include "scene/building.h"

namespace enfilade {

/// What the programs that export buildings call the leaves of doors, and windows: IFC's classes,
/// and the bare words with the numbers that Blender and SketchUp add.
inline constexpr const char* kUsualDoors =
    "IfcDoor*,Door,Doors,Door/*,Door.???,Door_?,Door_??,Door_???,Door#*,"
    "door,doors,door/*,door.???,door_?,door_??,door_???,door#*";
inline constexpr const char* kUsualWindows =
    "IfcWindow*,Window,Windows,Window/*,Window.???,Window_?,Window_??,Window_???,Window#*,"
    "window,windows,window/*,window.???,window_?,window_??,window_???,window#*";

/// Doors and glass by the patterns of their names, one role an object.
std::vector<ObjectRole> namedRoles(const Building& building, const std::string& doors,
                                   const std::string& windows);

/// Makes fixed what is called a door but stands in none of the portals (a cupboard's), so that it
/// is drawn; says so in the cells' log.
void fixDoorsWithoutPortals(const Building& building, CutCells& cells,
                            std::vector<ObjectRole>& roles);

}  // namespace enfilade
