#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "portals/graph_values.h"
#include "portals/house_json.h"
#include "portals/house_names.h"
#include "portals/json_value.h"
#include "scene/error.h"
#include "scene/format_version.h"
#include "scene/json_depth.h"

namespace enfilade {

namespace {

/// Objects times cells that see them, of which a small file could name very many.
constexpr std::size_t kMostObjectCells = std::size_t{1} << 26;

Leak readLeak(const JsonValue& value) {
  Leak leak{value["room"].string(), value["into"].string(), {}, value["place"].vector()};
  const JsonValue path = value["path"];
  if (path.size() < 2) path.fail("has not two points");
  for (std::size_t i = 0; i < path.size(); ++i) leak.path.push_back(path.at(i).vector());
  return leak;
}

void readInfo(const JsonValue& root, HouseInfo& info) {
  info.tool_version = root["tool_version"].string();
  info.model_name = root["model"]["name"].string();
  info.model_sha256 = root["model"]["sha256"].string();
  root["parameters"].forEachMember([&](const std::string& name, const JsonValue& value) {
    info.parameters[name] = value.string();
  });
  root["statistics"].forEachMember([&](const std::string& name, const JsonValue& value) {
    info.statistics[name] =
        value.isNull() ? std::numeric_limits<double>::quiet_NaN() : value.number();
  });
  const JsonValue log = root["log"];
  for (std::size_t i = 0; i < log.size(); ++i) info.log.push_back(log.at(i).string());
  if (!root.has("leaks")) return;  // houses of versions that did not tell them
  const JsonValue leaks = root["leaks"];
  for (std::size_t i = 0; i < leaks.size(); ++i) info.leaks.push_back(readLeak(leaks.at(i)));
}

Cell readCell(const JsonValue& value, std::size_t storeys) {
  Cell cell;
  cell.name = value["name"].string();
  cell.storey = static_cast<int>(value["storey"].index(storeys));
  const JsonValue bounds = value["bounds"];
  if (!bounds.isNull()) {
    if (bounds.size() != 2) bounds.fail("has not two corners");
    cell.bounds = {bounds.at(0).vector(), bounds.at(1).vector()};
  }
  cell.volume = value["volume"].real();
  cell.floor_area = value["floor_area"].real();
  return cell;
}

Portal readPortal(const JsonValue& value, std::size_t cells) {
  Portal portal;
  portal.name = value["name"].string();
  portal.kind = readPortalKind(value["kind"]);
  portal.front = value["front"].index(cells);
  portal.back = value["back"].index(cells);
  if (portal.front == portal.back) value.fail("has the same cell on both sides");
  portal.two_way = value["two_way"].boolean();
  portal.active = value["active"].boolean();
  const JsonValue plane = value["plane"];
  if (plane.size() != 4) plane.fail("has not four numbers");
  portal.plane = {{plane.at(0).real(), plane.at(1).real(), plane.at(2).real()}, plane.at(3).real()};
  if (!(std::abs(glm::length(portal.plane.normal) - 1.0f) < 1e-3f)) {
    plane.fail("has no normal of unit length");
  }
  portal.polygon = readPolygon(value["polygon"]);
  return portal;
}

CellGraph readGraph(const JsonValue& root) {
  CellGraph graph;
  const JsonValue storeys = root["storeys"];
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    graph.storeys.push_back({storeys.at(i)["name"].string(), storeys.at(i)["floor_y"].real()});
  }
  if (graph.storeys.empty()) storeys.fail("is empty");
  const JsonValue cells = root["cells"];
  if (cells.size() < 1 || cells.size() > CellGrid::kCutVoxel) {
    cells.fail("has an impossible number of cells");
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    graph.cells.push_back(readCell(cells.at(i), graph.storeys.size()));
  }
  const JsonValue portals = root["portals"];
  for (std::size_t i = 0; i < portals.size(); ++i) {
    graph.portals.push_back(readPortal(portals.at(i), graph.cells.size()));
  }
  linkCells(graph);
  return graph;
}

std::vector<CellId> readCellSet(const JsonValue& value, std::size_t cells) {
  std::vector<CellId> set;
  for (std::size_t i = 0; i < value.size(); ++i) {
    set.push_back(value.at(i).index(cells));
    if (i > 0 && set[i - 1] >= set[i]) value.fail("does not increase");
  }
  return set;
}

void readObjects(const JsonValue& value, House& house) {
  const JsonValue sets = value["cell_sets"];
  std::vector<std::vector<CellId>> cell_sets;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    cell_sets.push_back(readCellSet(sets.at(i), house.graph.cells.size()));
  }
  const JsonValue set_of_object = value["cell_set_of_object"];
  std::vector<std::uint32_t> set_numbers;
  std::size_t total = 0;
  for (std::size_t i = 0; i < set_of_object.size(); ++i) {
    set_numbers.push_back(set_of_object.at(i).index(cell_sets.size()));
    total += cell_sets[set_numbers.back()].size();
  }
  if (total > kMostObjectCells) set_of_object.fail("names too many cells for too many objects");
  for (const std::uint32_t number : set_numbers) house.object_cells.push_back(cell_sets[number]);
  house.object_roles.assign(house.object_cells.size(), ObjectRole::kFixed);
  for (const auto& [role, name] : kListedRoleNames) {
    const JsonValue objects = value["roles"][std::string(name).c_str()];
    for (std::size_t i = 0; i < objects.size(); ++i) {
      house.object_roles[objects.at(i).index(house.object_roles.size())] = role;
    }
  }
}

HouseFiles readFiles(const JsonValue& value) {
  HouseFiles files;
  value.forEachMember([&](const std::string& name, const JsonValue& file) {
    files[name] = file["xxh3"].checksum();
  });
  return files;
}

/// Whether the text still is what was written.  Its last string is the checksum.
bool isUndamaged(const std::string& text) {
  const std::size_t end = text.rfind('"');
  if (end == std::string::npos || end < 17 || text[end - 17] != '"') return false;
  return text.compare(end - 16, 16, ownChecksum(text, end - 16)) == 0;
}

}  // namespace

void decodeHouseJson(const std::string& text, const std::string& file, House& house) {
  requireShallowJson(text, file);
  const auto parsed = nlohmann::json::parse(text, nullptr, false);
  if (parsed.is_discarded()) {
    throw Error(ErrorKind::kBadInput, file, "is not JSON: cut short, or damaged");
  }
  const JsonValue root(parsed, "", file);
  if (!parsed.is_object() || !parsed.contains("enfilade") || parsed["enfilade"] != "house") {
    root.fail("does not describe a house");
  }
  const double format = root["format"].number();
  if (format != kHouseFormatVersion) {
    root.fail(otherFormatVersion(format, kHouseFormatVersion));
  }
  if (!isUndamaged(text)) {
    root.fail("is damaged, or was edited: its checksum differs; preprocess the model again");
  }
  readInfo(root, house.info);
  house.switch_distance = root["switch_distance"].positive();
  house.eye_height = root["eye_height"].positive();
  house.graph = readGraph(root);
  readObjects(root["objects"], house);
  house.files = readFiles(root["files"]);
}

}  // namespace enfilade
