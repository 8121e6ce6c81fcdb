#include "portals/given_graph.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "portals/graph_values.h"
#include "portals/grid_file.h"
#include "portals/house_files.h"
#include "portals/json_value.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/json_depth.h"

namespace enfilade {
namespace {

std::vector<Storey> readStoreys(const JsonValue& value) {
  std::vector<Storey> storeys;
  for (std::size_t i = 0; i < value.size(); ++i) {
    storeys.push_back({value.at(i)["name"].string(), value.at(i)["floor_y"].real()});
    if (i > 0 && !(storeys[i - 1].floor_y < storeys[i].floor_y)) {
      value.at(i).fail("is no higher than the storey before it");
    }
  }
  if (storeys.empty()) value.fail("is empty");
  return storeys;
}

/// Cells by what a portal may call them.
struct CellsByReference {
  std::map<CellId, CellId> by_id;
  std::map<std::string, CellId> by_name;
};

void readCells(const JsonValue& value, GivenGraph& given, CellsByReference& known) {
  std::vector<Cell>& cells = given.graph.cells;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const JsonValue at = value.at(i);
    const CellId label = at["id"].index(CellGrid::kCutVoxel);
    Cell cell;
    cell.name = at["name"].string();
    const auto number = static_cast<CellId>(i);
    if (const auto [other, is_new] = known.by_id.try_emplace(label, number); !is_new) {
      at.fail(fmt::format("has the id of cells[{}], {}", other->second, label));
    }
    if (const auto [other, is_new] = known.by_name.try_emplace(cell.name, number); !is_new) {
      at.fail(fmt::format("has the name of cells[{}], '{}'", other->second, cell.name));
    }
    if (at.has("storey")) {
      cell.storey = static_cast<int>(at["storey"].index(given.graph.storeys.size()));
    }
    if (at.has("bounds") && !at["bounds"].isNull()) {
      const JsonValue bounds = at["bounds"];
      if (bounds.size() != 2) bounds.fail("has not two corners");
      cell.bounds = {bounds.at(0).vector(), bounds.at(1).vector()};
    }
    given.labels.push_back(label);
    cells.push_back(std::move(cell));
  }
  if (cells.empty() || given.labels[0] != kExterior) {
    value.fail("does not begin with the exterior, id 0");
  }
}

/// A cell by its id in the file or by its name.
CellId readCellReference(const JsonValue& value, const CellsByReference& known) {
  if (value.isString()) {
    const std::string name = value.string();
    const auto found = known.by_name.find(name);
    if (found == known.by_name.end()) value.fail("is '" + name + "', the name of no cell");
    return found->second;
  }
  const CellId label = value.index(CellGrid::kCutVoxel);
  const auto found = known.by_id.find(label);
  if (found == known.by_id.end()) value.fail(fmt::format("is {}, the id of no cell", label));
  return found->second;
}

Portal readGivenPortal(const JsonValue& value, std::size_t number, const CellsByReference& known) {
  Portal portal;
  portal.polygon = readPolygon(value["polygon"]);
  portal.plane = planeOf(portal.polygon);
  portal.front = readCellReference(value["front"], known);
  portal.back = readCellReference(value["back"], known);
  portal.name = value.has("name") ? value["name"].string() : fmt::format("portal-{}", number);
  if (value.has("kind")) portal.kind = readPortalKind(value["kind"]);
  if (value.has("two_way")) portal.two_way = value["two_way"].boolean();
  if (value.has("active")) portal.active = value["active"].boolean();
  return portal;
}

void requireSoundPortals(const CellGraph& graph, const std::string& file) {
  for (const std::string& problem : diagnose(graph)) {
    // A cell without a portal may yet be joined to another, by what the voxels say.
    if (problem.starts_with("portal")) throw Error(ErrorKind::kBadInput, file, problem);
  }
}

std::string parameterOf(const JsonValue& root, const char* name) {
  if (!root.has("parameters") || !root["parameters"].has(name)) return {};
  return root["parameters"][name].string();
}

std::optional<CellGrid> readGridBeside(const std::string& file) {
  const auto grid = std::filesystem::path(file).parent_path() / "cells.grid";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(grid, ignored)) return std::nullopt;
  return decodeGrid(readFile(grid.string()), grid.string());
}

}  // namespace

GivenGraph decodeGivenGraph(std::span<const std::uint8_t> bytes, const std::string& file) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  requireShallowJson(text, file);
  const auto parsed = nlohmann::json::parse(text, nullptr, false);
  const JsonValue root(parsed, "", file);
  if (parsed.is_discarded()) root.fail("is not JSON");
  GivenGraph given;
  given.graph.storeys = readStoreys(root["storeys"]);
  CellsByReference known;
  readCells(root["cells"], given, known);
  const JsonValue portals = root["portals"];
  for (std::size_t i = 0; i < portals.size(); ++i) {
    given.graph.portals.push_back(readGivenPortal(portals.at(i), i, known));
  }
  requireSoundPortals(given.graph, file);
  linkCells(given.graph);
  given.doors = parameterOf(root, "doors");
  given.windows = parameterOf(root, "windows");
  given.sha256 = sha256Hex(bytes);
  return given;
}

GivenGraph readGivenGraph(const std::string& file) {
  GivenGraph given = decodeGivenGraph(readFile(file, kMostHouseJsonBytes), file);
  given.grid = readGridBeside(file);
  return given;
}

}  // namespace enfilade
