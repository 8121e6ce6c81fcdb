#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "portals/cell_graph.h"
#include "portals/cell_grid.h"
#include "portals/house_files.h"
#include "portals/leak.h"
#include "scene/building.h"

namespace enfilade {

inline constexpr int kHouseFormatVersion = 2;

enum class ObjectRole : std::uint8_t {
  kFixed,
  kDoor,   ///< openable: not an obstacle, not drawn while walking
  kGlass,  ///< a window that can be seen through: drawn, but no obstacle to sight
};

/// One flag a role: whether it is a door's.  Doors stand open: they are hidden from rays.
std::vector<std::uint8_t> doorFlags(std::span<const ObjectRole> roles);

/// What a house says of where it comes from.
struct HouseInfo {
  std::string tool_version;
  std::string model_name;
  std::string model_sha256;
  std::map<std::string, std::string>
      parameters;  ///< every parameter used, as text, units in the name
  std::map<std::string, double>
      statistics;                ///< counts, sizes, seconds of nothing: same bytes run after run
  std::vector<std::string> log;  ///< what was cut, merged, dropped, and why
  std::vector<Leak> leaks;
};

/// A preprocessed building, all but its images: what playback needs, and nothing else.
struct House {
  HouseInfo info;
  CellGraph graph;
  CellGrid grid;
  Building building;                     ///< each object lies in one set of cells
  std::vector<ObjectRole> object_roles;  ///< one an object
  std::vector<std::vector<CellId>>
      object_cells;              ///< one an object, increasing: the cells that can see it
  float switch_distance = 1.5f;  ///< [m] > 0: nearer to a portal than this: geometry
  float eye_height = 1.6f;       ///< [m] above the floor
  HouseFiles files;  ///< its images, and, where it was read from a folder, geometry and grid
};

/// Whether `path` is a folder with a house.json.
bool isHouse(const std::string& path);

/// Writes house.json, geometry.glb and cells.grid; house.json last, an old one removed first, so
/// that a folder without one is no house.  Images that stand in the folder are left as they are;
/// those in `house.files` are listed.  The same bytes for the same house.  Throws Error (kMachine).
void writeHouse(const std::string& folder, const House& house);

/// The house in a folder, its images unread.  Throws Error (kBadInput) that names the file and the
/// reason: not a house or not yet finished, another format version and what to do, cut short or
/// damaged (house.json ends with its own checksum and lists those of all others), ids out of range.
House readHouse(const std::string& folder);

}  // namespace enfilade
