#include "cell_truth.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

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

std::vector<std::pair<glm::vec2, glm::vec2>> sliceMesh(const Json& mesh, float y) {
  const auto& p = mesh["positions"];
  const auto& indices = mesh["indices"];
  std::vector<std::pair<glm::vec2, glm::vec2>> segments;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    std::vector<glm::vec2> cut;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t c) {
        const auto v = indices[i + c % 3].get<std::size_t>() * 3;
        return glm::vec3(p[v].get<float>(), p[v + 1].get<float>(), p[v + 2].get<float>());
      };
      const glm::vec3 a = at(k), b = at(k + 1);
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

void addColumns(const Json& space, const VoxelGrid& grid, TrueRoom& room) {
  const glm::vec3 lo = toVec3(space["bounds"]["min"]), hi = toVec3(space["bounds"]["max"]);
  const auto segments = sliceMesh(space["mesh"], lo.y + 1.2f);
  const glm::ivec3 first = grid.voxelOf(lo), last = grid.voxelOf(hi);
  for (int x = first.x; x <= last.x; ++x) {
    for (int z = first.z; z <= last.z; ++z) {
      const glm::vec3 c = grid.centerOf({x, 0, z});
      if (insideSlice(segments, c.x, c.z)) room.columns.push_back({x, z});
    }
  }
}

void addRooms(const Json& json, const VoxelGrid& grid, Truth& truth) {
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
    addColumns(space, grid, room);
  }
}

/// Openings that a door or window fills count once, and furniture's not at all.
bool counts(const Json& opening) {
  if (!opening["portal"].is_object()) return false;
  return opening["class"] != "IfcOpeningElement" ||
         (opening.value("filledBy", Json()).is_null() &&
          opening.value("hostClass", "") != "IfcFurnishingElement");
}

}  // namespace

Truth readTruth(const std::string& file, const VoxelGrid& grid) {
  std::ifstream stream(file);
  const Json json = Json::parse(stream);
  Truth truth;
  if (!json.contains("spaces")) return truth;
  addRooms(json, grid, truth);
  for (const char* kind : {"doors", "windows", "openings"}) {
    for (const Json& json_opening : json[kind]) {
      if (!counts(json_opening)) continue;
      const Json& portal = json_opening["portal"];
      TrueOpening& opening = truth.openings.emplace_back();
      opening.name = json_opening.value("name", "");
      opening.kind = kind;
      opening.center = toVec3(portal["center"]);
      opening.normal = toVec3(portal["normal"]);
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
