#include "portals/given_graph.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "portals/graph_values.h"
#include "portals/grid_file.h"
#include "portals/json_value.h"
#include "scene/error.h"
#include "scene/file_io.h"

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

void readCells(const JsonValue& value, GivenGraph& given) {
  std::vector<Cell>& cells = given.graph.cells;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const JsonValue at = value.at(i);
    const CellId label = at["id"].index(CellGrid::kCutVoxel);
    Cell cell;
    cell.name = at["name"].string();
    for (std::size_t j = 0; j < i; ++j) {
      if (given.labels[j] == label) at.fail(fmt::format("has the id of cells[{}], {}", j, label));
      if (cells[j].name == cell.name) {
        at.fail(fmt::format("has the name of cells[{}], '{}'", j, cell.name));
      }
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
CellId readCellReference(const JsonValue& value, const GivenGraph& given) {
  const auto& cells = given.graph.cells;
  const std::string name = value.isString() ? value.string() : std::string();
  const CellId label = value.isString() ? kNoCell : value.index(CellGrid::kCutVoxel);
  for (CellId i = 0; i < cells.size(); ++i) {
    if (value.isString() ? cells[i].name == name : given.labels[i] == label) return i;
  }
  value.fail(value.isString() ? "is '" + name + "', the name of no cell"
                              : fmt::format("is {}, the id of no cell", label));
}

Portal readGivenPortal(const JsonValue& value, std::size_t number, const GivenGraph& given) {
  Portal portal;
  portal.polygon = readPolygon(value["polygon"]);
  portal.plane = planeOf(portal.polygon);
  portal.front = readCellReference(value["front"], given);
  portal.back = readCellReference(value["back"], given);
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

GivenGraph readGivenGraph(const std::string& file) {
  const std::vector<std::uint8_t> bytes = readFile(file);
  const auto parsed = nlohmann::json::parse(bytes, nullptr, false);
  const JsonValue root(parsed, "", file);
  if (parsed.is_discarded()) root.fail("is not JSON");
  GivenGraph given;
  given.graph.storeys = readStoreys(root["storeys"]);
  readCells(root["cells"], given);
  const JsonValue portals = root["portals"];
  for (std::size_t i = 0; i < portals.size(); ++i) {
    given.graph.portals.push_back(readGivenPortal(portals.at(i), i, given));
  }
  requireSoundPortals(given.graph, file);
  linkCells(given.graph);
  given.doors = parameterOf(root, "doors");
  given.windows = parameterOf(root, "windows");
  given.grid = readGridBeside(file);
  given.sha256 = sha256Hex(bytes);
  return given;
}

}  // namespace enfilade
