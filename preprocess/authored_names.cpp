#include "preprocess/authored_names.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "preprocess/marker_outline.h"

namespace enfilade {

namespace {

using nlohmann::json;

// The value of a key in a node's extras.enfilade; null without one.
json extra(const Node& node, const char* key) {
  if (node.extras.empty()) return nullptr;
  const json extras = json::parse(node.extras, nullptr, false);
  return extras.is_object() && extras.contains(key) ? extras[key] : json(nullptr);
}

// NAME of a node called NAME-SUFFIX or NAME-SUFFIX-NUMBER; nothing if it is called otherwise.
std::optional<std::string> nameBefore(std::string_view name, std::string_view suffix) {
  if (name == suffix) return std::string();
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  if (digits < name.size()) {
    name = name.substr(0, digits);
    if (name.ends_with('-') || name.ends_with('_') || name.ends_with('.')) name.remove_suffix(1);
  }
  if (!name.ends_with(suffix)) return std::nullopt;
  name.remove_suffix(suffix.size());
  if (!name.ends_with('-')) return std::nullopt;
  return std::string(name.substr(0, name.size() - 1));
}

std::optional<std::string> roomName(const Node& node) {
  if (const json cell = extra(node, "cell"); cell.is_string()) return cell.get<std::string>();
  const auto name = nameBefore(node.name, "room");
  return name && !name->empty() ? name : std::nullopt;
}

bool isPortal(const Node& node) {
  return extra(node, "portal").is_object() || nameBefore(node.name, "portal").has_value();
}

bool isBound(const Node& node) { return nameBefore(node.name, "bound").has_value(); }

// For each node the room that it belongs to (index, or kNone): the nearest one above it.
std::vector<std::uint32_t> roomOfNodes(const Building& building, AuthoredNames& names) {
  std::vector<std::uint32_t> room(building.nodes.size(), kNone);
  std::unordered_map<std::string, std::uint32_t> known;  // looked up, never walked through
  for (std::size_t n = 0; n < building.nodes.size(); ++n) {
    const Node& node = building.nodes[n];
    if (node.parent != kNone) room[n] = room[node.parent];
    const auto name = roomName(node);
    if (!name || isPortal(node) || isBound(node) || *name == "exterior") continue;
    const auto [at, is_new] =
        known.try_emplace(*name, static_cast<std::uint32_t>(names.rooms.size()));
    if (is_new) names.rooms.push_back({*name, {}, {}, glm::vec3(node.world_from_node[3])});
    room[n] = at->second;
  }
  return room;
}

std::string textOf(const json& extras, const char* key) {
  const auto value = extras.find(key);
  return value != extras.end() && value->is_string() ? value->get<std::string>() : std::string();
}

/// True unless it says otherwise.
bool flagOf(const json& extras, const char* key) {
  const auto value = extras.find(key);
  return value == extras.end() || !value->is_boolean() || value->get<bool>();
}

PortalKind kindOf(const json& extras) {
  const std::string kind = textOf(extras, "kind");
  if (kind == "door") return PortalKind::kDoor;
  return kind == "window" ? PortalKind::kWindow : PortalKind::kOpening;
}

void takePortal(const Building& building, const Object& object, std::uint32_t room,
                AuthoredNames& names) {
  const Node& node = building.nodes[object.node];
  AuthoredNames::NamedPortal named;
  named.portal.name = node.name;
  named.portal.polygon = outlineOf(building, object);
  if (named.portal.polygon.size() < 3) {
    names.warnings.push_back(node.name + ": left out: a portal must be one flat convex piece");
    return;
  }
  const json extras = extra(node, "portal");
  named.portal.kind = kindOf(extras);
  if (extras.is_object()) {
    named.portal.two_way = flagOf(extras, "two_way");
    named.portal.active = flagOf(extras, "active");
    named.to = textOf(extras, "to");
  }
  if (named.to.empty()) named.to = nameBefore(node.name, "portal").value_or("");
  if (room != kNone) {
    named.from = names.rooms[room].name;
    named.portal.name = named.from + "/" + node.name;
  }
  names.portals.push_back(std::move(named));
}

void takeBound(const Building& building, const Object& object, AuthoredNames::Room& room) {
  const Mesh& mesh = building.meshOf(object);
  const auto& positions = building.vertex_arrays[mesh.vertices].positions;
  const glm::mat4& world_from_object = building.worldFromObject(object);
  room.bounds = worldBounds(building, object);
  const glm::vec3 inside = room.bounds.center();
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::vector<glm::vec3> triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.emplace_back(world_from_object * glm::vec4(positions[mesh.indices[i + k]], 1.0f));
    }
    Plane plane = planeOf(triangle);
    if (plane.signedDistance(inside) < 0) plane = {-plane.normal, -plane.d};
    room.bound_planes.push_back(plane);
  }
}

}  // namespace

AuthoredNames takeAuthoredNames(Building& building) {
  AuthoredNames names;
  const std::vector<std::uint32_t> room = roomOfNodes(building, names);
  if (names.rooms.empty()) return names;
  std::vector<Object> kept;
  for (const Object& object : building.objects) {
    const Node& node = building.nodes[object.node];
    const std::uint32_t r = room[object.node];
    if (isPortal(node)) {
      takePortal(building, object, r, names);
    } else if (isBound(node)) {
      if (r != kNone) takeBound(building, object, names.rooms[r]);
    } else {
      kept.push_back(object);
    }
  }
  building.objects = std::move(kept);
  for (const Object& object : building.objects) {
    const std::uint32_t r = room[object.node];
    if (r == kNone || !names.rooms[r].bound_planes.empty()) continue;
    names.rooms[r].bounds.extend(worldBounds(building, object));
  }
  return names;
}

}  // namespace enfilade
