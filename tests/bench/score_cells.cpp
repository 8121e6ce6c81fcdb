// Scores the automatic cells and portals of a building against what its author's program says of
// it (NAME.semantics.json, or names in the model): rooms, doors, windows, and how well the portals
// fit.
//   score_cells MODEL.glb SEMANTICS.json [--doors P] [--windows P] [--voxel M] [--turn DEGREES]
//     [--plan PREFIX] [-v]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <set>

#include "cell_plan.h"
#include "cell_truth.h"
#include "preprocess/cut_cells.h"
#include "preprocess/object_roles.h"
#include "scene/error.h"
#include "scene/gltf_reader.h"

namespace enfilade {
namespace {

struct Options {
  std::string model, semantics, plan;
  std::string doors = kUsualDoors, windows = kUsualWindows;
  CellParameters cells;
  float turn = 0;  ///< [degrees] about +Y, of the building
  bool verbose = false;
};

Options parse(int argc, char** argv) {
  Options options;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    const auto next = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string("0"); };
    if (a == "-v") {
      options.verbose = true;
    } else if (a == "--voxel") {
      options.cells.voxel = std::stof(next());
    } else if (a == "--turn") {
      options.turn = std::stof(next());
    } else if (a.rfind("--", 0) == 0) {
      (a == "--doors" ? options.doors : a == "--windows" ? options.windows : options.plan) = next();
    } else {
      files.push_back(a);
    }
  }
  if (files.empty()) throw Error(ErrorKind::kUsage, "", "score_cells MODEL.glb [SEMANTICS.json]");
  options.model = files[0];
  if (files.size() > 1) options.semantics = files[1];
  return options;
}

/// The cell that overlaps most with the room, relative to their union.
void matchRoom(const VoxelGrid& grid, const CutCells& cut, TrueRoom& room) {
  const int y = grid.voxelOf({0, room.slice_y, 0}).y;
  std::map<int, int> inside, areas;
  for (int x = 0; x < grid.size.x; ++x) {
    for (int z = 0; z < grid.size.z; ++z) ++areas[labelAt(grid, cut, {x, y, z})];
  }
  for (const auto& [x, z] : room.columns) ++inside[labelAt(grid, cut, {x, y, z})];
  for (const auto& [cell, count] : inside) {
    if (cell == 0 || cell >= CellGrid::kCutVoxel) continue;
    const float iou = float(count) / float(int(room.columns.size()) + areas[cell] - count);
    if (iou <= room.iou) continue;
    room.iou = iou;
    room.cell = cell;
  }
}

void scoreRooms(const VoxelGrid& grid, const CutCells& cut, Truth& truth, bool verbose) {
  int found = 0;
  std::set<int> good;
  for (TrueRoom& room : truth.rooms) {
    matchRoom(grid, cut, room);
    if (room.iou >= 0.5f) {
      ++found;
      good.insert(room.cell);
    }
    if (!verbose && room.iou >= 0.5f) continue;
    fmt::print("  room {} at y {:.1f}, {:.1f} m²: {}, {:.2f}\n", room.name, room.slice_y,
               float(room.columns.size()) * grid.voxel * grid.voxel,
               room.cell < 0 ? "none" : cut.graph.cells[std::size_t(room.cell)].name, room.iou);
  }
  const std::size_t cells = cut.graph.cells.size() - 1;
  fmt::print("rooms found {} of {}; cells {}, of them {} are no room\n", found, truth.rooms.size(),
             cells, cells - good.size());
}

float median(std::vector<float> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

float widthOf(const Portal& p) { return glm::distance(p.polygon[0], p.polygon[1]); }
float heightOf(const Portal& p) { return glm::distance(p.polygon[1], p.polygon[2]); }

struct PortalScores {
  std::map<std::string, std::array<int, 3>> counts;  ///< all, near, with the right cells
  std::vector<float> offsets, widths, heights;       ///< [m] errors
  std::set<std::size_t> used;
};

/// The portal whose centre lies nearest, within 0.3 m; the number of portals if none does.
std::size_t nearestPortal(const CutCells& cut, const glm::vec3& center) {
  std::size_t best = cut.graph.portals.size();
  float nearest = 0.3f;
  for (std::size_t i = 0; i < cut.graph.portals.size(); ++i) {
    const float distance = glm::distance(cut.graph.portals[i].center(), center);
    if (distance >= nearest) continue;
    nearest = distance;
    best = i;
  }
  return best;
}

/// Whether the portal's cells are the opening's rooms.  Outside, or in no room: the exterior, or a
/// cell that is no room of the truth; so too a room that no cell matches (a roof terrace, say).
bool joinsRightCells(const Portal& portal, const TrueOpening& opening, const Truth& truth) {
  if (!opening.rooms_known) return true;
  const auto cellOf = [&](int room) {
    return room < 0 ? 0 : std::max(0, truth.rooms[std::size_t(room)].cell);
  };
  const auto roomCell = [&](CellId cell) {
    const bool is_room = std::any_of(truth.rooms.begin(), truth.rooms.end(),
                                     [&](const TrueRoom& room) { return room.cell == int(cell); });
    return is_room ? int(cell) : 0;
  };
  const std::multiset<int> wanted{cellOf(opening.rooms[0]), cellOf(opening.rooms[1])};
  return wanted == std::multiset<int>{roomCell(portal.front), roomCell(portal.back)};
}

void scoreOpening(const CutCells& cut, const Truth& truth, const TrueOpening& opening, bool verbose,
                  PortalScores& scores) {
  auto& count = scores.counts[opening.kind];
  ++count[0];
  const std::size_t best = nearestPortal(cut, opening.center);
  std::string verdict = "MISSED";
  if (best < cut.graph.portals.size()) {
    const Portal& portal = cut.graph.portals[best];
    const bool right = joinsRightCells(portal, opening, truth);
    ++count[1];
    count[2] += right;
    scores.used.insert(best);
    scores.offsets.push_back(std::abs(glm::dot(opening.normal, portal.center() - opening.center)));
    scores.widths.push_back(std::abs(widthOf(portal) - opening.width));
    scores.heights.push_back(std::abs(heightOf(portal) - opening.height));
    verdict = fmt::format("{} {}, off {:.3f}, width {:.3f}, height {:.3f}",
                          right ? "ok" : "WRONG CELLS", portal.name, scores.offsets.back(),
                          scores.widths.back(), scores.heights.back());
  }
  if (!verbose && verdict[0] == 'o') return;
  fmt::print("  {} {} at {:.2f} {:.2f} {:.2f}, {:.2f} × {:.2f}: {}\n", opening.kind, opening.name,
             opening.center.x, opening.center.y, opening.center.z, opening.width, opening.height,
             verdict);
}

void scorePortals(const CutCells& cut, const Truth& truth, bool verbose) {
  PortalScores scores;
  for (const TrueOpening& opening : truth.openings) {
    scoreOpening(cut, truth, opening, verbose, scores);
  }
  for (const auto& [kind, c] : scores.counts) {
    fmt::print("{}: {} of {} near, {} with the right cells\n", kind, c[1], c[0], c[2]);
  }
  fmt::print("median error of the plane {:.3f} m, the width {:.3f} m, the height {:.3f} m\n",
             median(scores.offsets), median(scores.widths), median(scores.heights));
  for (std::size_t i = 0; i < cut.graph.portals.size(); ++i) {
    if (scores.used.contains(i)) continue;
    const Portal& p = cut.graph.portals[i];
    const glm::vec3 c = p.center();
    fmt::print("  other {} at {:.2f} {:.2f} {:.2f}, {:.2f} × {:.2f}\n", p.name, c.x, c.y, c.z,
               widthOf(p), heightOf(p));
  }
  fmt::print("portals {}, of them {} are no door, window or opening of the truth\n",
             cut.graph.portals.size(), cut.graph.portals.size() - scores.used.size());
}

void run(const Options& options) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](auto a, auto b) { return std::chrono::duration<double>(b - a).count(); };
  Building building = readGltf(options.model);
  const glm::mat4 turned =
      glm::rotate(glm::mat4(1), glm::radians(options.turn), glm::vec3(0, 1, 0));
  for (Node& node : building.nodes) node.world_from_node = turned * node.world_from_node;
  const AuthoredNames names = takeAuthoredNames(building);
  const auto roles = namedRoles(building, options.doors, options.windows);
  const auto start = Clock::now();
  const VoxelGrid grid = voxelise(building, roles, options.cells.voxel);
  const auto voxelised = Clock::now();
  const CellProposal proposal = findCells(building, roles, grid, options.cells);
  const auto found = Clock::now();
  const CutCells cut = cutCells(grid, proposal);
  const auto done = Clock::now();
  fmt::print("{}: {} × {} × {} voxels; voxelise {:.2f} s, find {:.2f} s, cut {:.2f} s\n",
             options.model, grid.size.x, grid.size.y, grid.size.z, seconds(start, voxelised),
             seconds(voxelised, found), seconds(found, done));
  for (const Storey& s : cut.graph.storeys) fmt::print("{} at {:.2f}\n", s.name, s.floor_y);
  for (const std::string& line : cut.log) fmt::print("  log: {}\n", line);
  Truth truth;
  if (!options.semantics.empty()) {
    truth = readTruth(options.semantics, grid, glm::mat3(turned));
  } else if (!names.empty()) {
    truth = authoredTruth(names, grid);
  }
  scoreRooms(grid, cut, truth, options.verbose);
  scorePortals(cut, truth, options.verbose);
  if (options.plan.empty()) return;
  for (const Storey& s : cut.graph.storeys) {
    drawPlan(options.plan + s.name + ".png", grid, cut, s.floor_y + 1.2f, truth);
  }
}

}  // namespace
}  // namespace enfilade

int main(int argc, char** argv) {
  try {
    enfilade::run(enfilade::parse(argc, argv));
    return 0;
  } catch (const enfilade::Error& error) {
    fmt::print(stderr, "score_cells: {}\n", error.what());
    return static_cast<int>(error.kind());
  }
}
