#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "portals/cell_graph.h"
#include "portals/cell_grid.h"

namespace enfilade {

/// A cell graph that someone wrote or edited, to be made true for a building.
struct GivenGraph {
  CellGraph graph;                 ///< planes from the polygons; sizes of cells not known
  std::vector<CellId> labels;      ///< one a cell: its number in the file, and in `grid`
  std::optional<CellGrid> grid{};  ///< which cell owned each voxel, if cells.grid lies beside it
  std::string doors, windows;      ///< the name patterns that it was made with
  std::string sha256;              ///< of the file
};

/// Reads a house.json by hand or by enfilade.  Of it are read
/// - `storeys` (`name`, `floor_y`),
/// - `cells`: `id` and `name`; perhaps `storey` (0) and `bounds`.  The first one is the exterior.
/// - `portals`: `polygon`, `front` and `back` (a cell's id or its name); perhaps `name`, `kind`
///   (opening), `two_way` and `active` (true).
/// - `parameters.doors` and `parameters.windows`, if there.
/// Checksums are not looked at, and what else there is neither.
/// Throws Error (kBadInput) that names the file and the place: values missing or out of range, two
/// cells of one id or name, polygons that are no convex planar ones, a damaged cells.grid.
GivenGraph readGivenGraph(const std::string& file);

/// The same of the bytes of `file`, and without what lies beside it.
GivenGraph decodeGivenGraph(std::span<const std::uint8_t> bytes, const std::string& file);

}  // namespace enfilade
