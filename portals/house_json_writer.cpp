#include <fmt/format.h>
#include <xxhash.h>

#include <cassert>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "portals/house_json.h"
#include "portals/house_names.h"
#include "portals/json_text.h"

namespace enfilade {

namespace {

using nlohmann::ordered_json;

ordered_json numbers(const glm::vec3& v) {
  return {shortDecimal(v.x), shortDecimal(v.y), shortDecimal(v.z)};
}

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Least and greatest corner; null for what is empty or without end.
ordered_json boxJson(const Box& box) {
  if (box.empty() || !finite(box.min) || !finite(box.max)) return nullptr;
  return {numbers(box.min), numbers(box.max)};
}

ordered_json storeysJson(const CellGraph& graph) {
  ordered_json storeys = ordered_json::array();
  for (const Storey& storey : graph.storeys) {
    storeys.push_back({{"name", storey.name}, {"floor_y", shortDecimal(storey.floor_y)}});
  }
  return storeys;
}

ordered_json cellsJson(const CellGraph& graph) {
  ordered_json cells = ordered_json::array();
  for (std::size_t id = 0; id < graph.cells.size(); ++id) {
    const Cell& cell = graph.cells[id];
    cells.push_back({{"id", id},
                     {"name", cell.name},
                     {"storey", cell.storey},
                     {"bounds", boxJson(cell.bounds)},
                     {"volume", shortDecimal(cell.volume)},
                     {"floor_area", shortDecimal(cell.floor_area)}});
  }
  return cells;
}

ordered_json portalsJson(const CellGraph& graph) {
  ordered_json portals = ordered_json::array();
  for (std::size_t id = 0; id < graph.portals.size(); ++id) {
    const Portal& portal = graph.portals[id];
    ordered_json polygon = ordered_json::array();
    for (const glm::vec3& corner : portal.polygon) polygon.push_back(numbers(corner));
    ordered_json plane = numbers(portal.plane.normal);
    plane.push_back(shortDecimal(portal.plane.d));
    portals.push_back({{"id", id},
                       {"name", portal.name},
                       {"kind", kindName(portal.kind)},
                       {"front", portal.front},
                       {"back", portal.back},
                       {"two_way", portal.two_way},
                       {"active", portal.active},
                       {"plane", std::move(plane)},
                       {"polygon", std::move(polygon)}});
  }
  return portals;
}

/// Many objects are seen from the same cells: each set of cells once, and its number for each
/// object.
ordered_json objectsJson(const House& house) {
  ordered_json sets = ordered_json::array();
  ordered_json set_of_object = ordered_json::array();
  std::map<std::vector<CellId>, std::size_t> known;
  for (const std::vector<CellId>& cells : house.object_cells) {
    const auto [entry, is_new] = known.try_emplace(cells, known.size());
    if (is_new) sets.push_back(cells);
    set_of_object.push_back(entry->second);
  }
  ordered_json roles;
  for (const auto& [role, name] : kListedRoleNames) {
    ordered_json& objects = roles[std::string(name)] = ordered_json::array();
    for (std::size_t i = 0; i < house.object_roles.size(); ++i) {
      if (house.object_roles[i] == role) objects.push_back(i);
    }
  }
  return {{"count", house.object_cells.size()},
          {"roles", std::move(roles)},
          {"cell_sets", std::move(sets)},
          {"cell_set_of_object", std::move(set_of_object)}};
}

ordered_json leaksJson(const std::vector<Leak>& leaks) {
  ordered_json list = ordered_json::array();
  for (const Leak& leak : leaks) {
    ordered_json path = ordered_json::array();
    for (const glm::vec3& p : leak.path) path.push_back(numbers(p));
    list.push_back({{"room", leak.room},
                    {"into", leak.into},
                    {"place", numbers(leak.place)},
                    {"path", std::move(path)}});
  }
  return list;
}

ordered_json statisticsJson(const HouseInfo& info) {
  ordered_json statistics = ordered_json::object();
  for (const auto& [name, value] : info.statistics) {
    if (value == std::floor(value) && std::abs(value) < 1e15) {
      statistics[name] = static_cast<std::int64_t>(value);
    } else {
      statistics[name] = value;  // null if it is not a finite number
    }
  }
  return statistics;
}

ordered_json filesJson(const HouseFiles& files) {
  ordered_json list = ordered_json::object();
  for (const auto& [name, checksum] : files) list[name] = {{"xxh3", checksumText(checksum)}};
  return list;
}

}  // namespace

std::string checksumText(std::uint64_t checksum) { return fmt::format("{:016x}", checksum); }

std::string ownChecksum(std::string text, std::size_t at) {
  text.replace(at, 16, 16, '0');
  return checksumText(XXH3_64bits(text.data(), text.size()));
}

std::string encodeHouseJson(const House& house, const HouseFiles& files) {
  assert(house.object_roles.size() == house.object_cells.size());
  ordered_json parameters = ordered_json::object();
  for (const auto& [name, value] : house.info.parameters) parameters[name] = value;
  const ordered_json json = {
      {"enfilade", "house"},
      {"format", kHouseFormatVersion},
      {"tool_version", house.info.tool_version},
      {"model", {{"name", house.info.model_name}, {"sha256", house.info.model_sha256}}},
      {"parameters", std::move(parameters)},
      {"switch_distance", shortDecimal(house.switch_distance)},
      {"eye_height", shortDecimal(house.eye_height)},
      {"storeys", storeysJson(house.graph)},
      {"cells", cellsJson(house.graph)},
      {"portals", portalsJson(house.graph)},
      {"objects", objectsJson(house)},
      {"statistics", statisticsJson(house.info)},
      {"log", house.info.log},
      {"leaks", leaksJson(house.info.leaks)},
      {"files", filesJson(files)},
      {"checksum", std::string(16, '0')}};
  std::string text = jsonText(json);
  const std::size_t at = text.rfind(std::string(16, '0'));
  text.replace(at, 16, ownChecksum(text, at));
  return text;
}

}  // namespace enfilade
