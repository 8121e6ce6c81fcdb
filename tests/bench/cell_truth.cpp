#include "cell_truth.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "preprocess/cut_cells.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

glm::vec3 toVec3(const Json& a) {
  return {a[0].get<float>(), a[1].get<float>(), a[2].get<float>()};
}

/// Whether (x, z) lies in the mesh's slice at y, by the parity of crossings towards +x.
bool insideSlice(const std::vector<std::pair<glm::vec2, glm::vec2>>& segments, float x, float z) {
  bool inside = false;
  for (const auto& [a, b] : segments) {
    if ((a.y > z) == (b.y > z)) continue;
    if (a.x + (b.x - a.x) * (z - a.y) / (b.y - a.y) > x) inside = !inside;
  }
  return inside;
}

std::vector<std::pair<glm::vec2, glm::vec2>> sliceMesh(const Json& mesh, float y,
                                                       const glm::mat3& turned, Box& bounds) {
  const auto& p = mesh["positions"];
  const auto& indices = mesh["indices"];
  std::vector<std::pair<glm::vec2, glm::vec2>> segments;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    std::vector<glm::vec2> cut;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t c) {
        const auto v = indices[i + c % 3].get<std::size_t>() * 3;
        return turned * glm::vec3(p[v].get<float>(), p[v + 1].get<float>(), p[v + 2].get<float>());
      };
      const glm::vec3 a = at(k), b = at(k + 1);
      bounds.extend(a);
      if ((a.y > y) == (b.y > y)) continue;
      const float t = (y - a.y) / (b.y - a.y);
      cut.push_back({a.x + t * (b.x - a.x), a.z + t * (b.z - a.z)});
    }
    if (cut.size() == 2) segments.push_back({cut[0], cut[1]});
  }
  return segments;
}

/// The spaces' groups: those with a virtual boundary between them are one.
std::vector<std::size_t> groupSpaces(const Json& json) {
  const Json& spaces = json["spaces"];
  std::map<std::string, std::size_t> index;
  for (const Json& space : spaces) index.emplace(space["globalId"], index.size());
  std::vector<std::size_t> parent(spaces.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i];
    return i;
  };
  for (const Json& boundary : json.value("virtualBoundaries", Json::array())) {
    if (!boundary["space"].is_string() || !boundary["otherSpace"].is_string()) continue;
    const auto a = index.find(boundary["space"]), b = index.find(boundary["otherSpace"]);
    if (a == index.end() || b == index.end()) continue;
    const std::size_t ra = find(a->second), rb = find(b->second);
    parent[std::max(ra, rb)] = std::min(ra, rb);
  }
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = find(i);
  return parent;
}

void addColumns(const Json& space, const VoxelGrid& grid, const glm::mat3& turned, TrueRoom& room) {
  Box bounds;
  const float floor = space["bounds"]["min"][1];
  const auto segments = sliceMesh(space["mesh"], floor + 1.2f, turned, bounds);
  const glm::ivec3 first = grid.voxelOf(bounds.min), last = grid.voxelOf(bounds.max);
  for (int x = first.x; x <= last.x; ++x) {
    for (int z = first.z; z <= last.z; ++z) {
      const glm::vec3 c = grid.centerOf({x, 0, z});
      if (insideSlice(segments, c.x, c.z)) room.columns.push_back({x, z});
    }
  }
}

void addRooms(const Json& json, const VoxelGrid& grid, const glm::mat3& turned, Truth& truth) {
  const auto groups = groupSpaces(json);
  std::map<std::size_t, int> room_of_group;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Json& space = json["spaces"][i];
    const auto [it, added] = room_of_group.emplace(groups[i], int(truth.rooms.size()));
    if (added) truth.rooms.emplace_back();
    TrueRoom& room = truth.rooms[static_cast<std::size_t>(it->second)];
    if (added) room.slice_y = space["bounds"]["min"][1].get<float>() + 1.2f;
    room.name += (added ? "" : "+") + space["name"].get<std::string>();
    truth.room_of_space[space["globalId"]] = it->second;
    addColumns(space, grid, turned, room);
  }
}

/// Openings that a door or window fills count once, and furniture's not at all.
bool counts(const Json& opening) {
  if (!opening["portal"].is_object()) return false;
  return opening["class"] != "IfcOpeningElement" ||
         (opening.value("filledBy", Json()).is_null() &&
          opening.value("hostClass", "") != "IfcFurnishingElement");
}

/// A door of a game map is a sector of its own between two lines; its middle lies between them.
void addSectorDoors(const Json& json, Truth& truth) {
  std::map<int, std::vector<const Json*>> faces;
  for (const Json& portal : json["portals"]) {
    for (const Json& cell : portal["cells"]) {
      if (json["cells"][cell.get<std::size_t>()]["door"]) faces[cell].push_back(&portal);
    }
  }
  for (const auto& [sector, lines] : faces) {
    TrueOpening& door = truth.openings.emplace_back();
    door.name = "sector " + std::to_string(sector);
    door.kind = "doors";
    door.rooms_known = false;
    for (const Json* line : lines) {
      const Json &a = (*line)["a"], &b = (*line)["b"];
      const glm::vec2 from{a[0], a[1]}, to{b[0], b[1]};
      const float low = (*line)["yMin"], high = (*line)["yMax"];
      const glm::vec2 along = glm::normalize(to - from);
      door.normal = {-along.y, 0, along.x};
      door.width = glm::distance(from, to);
      door.height = high - low;
      const glm::vec2 middle = (from + to) / 2.0f;
      door.center += glm::vec3(middle.x, (low + high) / 2, middle.y) / float(lines.size());
    }
  }
}

void addAuthoredRooms(const CutCells& cut, const VoxelGrid& grid, Truth& truth) {
  truth.rooms.resize(cut.graph.cells.size() - 1);
  for (std::size_t c = 1; c < cut.graph.cells.size(); ++c) {
    const Cell& cell = cut.graph.cells[c];
    TrueRoom& room = truth.rooms[c - 1];
    room.name = cell.name;
    room.slice_y = cell.bounds.min.y + 1.2f;
    const int y = grid.voxelOf({0, room.slice_y, 0}).y;
    for (int x = 0; x < grid.size.x; ++x) {
      for (int z = 0; z < grid.size.z; ++z) {
        if (cut.labels[grid.index(x, y, z)] == c) room.columns.push_back({x, z});
      }
    }
  }
}

}  // namespace

Truth authoredTruth(const AuthoredNames& names, const VoxelGrid& grid) {
  const CutCells cut = cutCells(grid, authoredCells(names, grid));
  Truth truth;
  addAuthoredRooms(cut, grid, truth);
  for (const Portal& portal : cut.graph.portals) {
    TrueOpening& opening = truth.openings.emplace_back();
    opening.name = portal.name;
    opening.kind = portal.kind == PortalKind::kDoor     ? "doors"
                   : portal.kind == PortalKind::kWindow ? "windows"
                                                        : "openings";
    opening.center = portal.center();
    opening.normal = portal.plane.normal;
    Box box;
    for (const glm::vec3& p : portal.polygon) box.extend(p);
    opening.height = box.size().y;
    opening.width = portal.area() / opening.height;
    opening.rooms = {int(portal.front) - 1, int(portal.back) - 1};
  }
  return truth;
}

Truth readTruth(const std::string& file, const VoxelGrid& grid, const glm::mat3& turned) {
  std::ifstream stream(file);
  const Json json = Json::parse(stream);
  Truth truth;
  if (!json.contains("spaces")) {
    addSectorDoors(json, truth);
    for (TrueOpening& door : truth.openings) {
      door.center = turned * door.center;
      door.normal = turned * door.normal;
    }
    return truth;
  }
  addRooms(json, grid, turned, truth);
  for (const char* kind : {"doors", "windows", "openings"}) {
    for (const Json& json_opening : json[kind]) {
      if (!counts(json_opening)) continue;
      const Json& portal = json_opening["portal"];
      TrueOpening& opening = truth.openings.emplace_back();
      opening.name = json_opening.value("name", "");
      opening.kind = kind;
      opening.center = turned * toVec3(portal["center"]);
      opening.normal = turned * toVec3(portal["normal"]);
      opening.width = portal["width"];
      opening.height = portal["height"];
      const Json& sides = json_opening["spacesBySide"];
      for (std::size_t side = 0; side < 2 && sides.is_array(); ++side) {
        if (!sides[side].is_string()) continue;
        const auto it = truth.room_of_space.find(sides[side]);
        if (it != truth.room_of_space.end()) opening.rooms[side] = it->second;
      }
    }
  }
  return truth;
}

}  // namespace enfilade
