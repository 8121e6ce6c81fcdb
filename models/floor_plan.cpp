#include "models/floor_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "models/json_view.h"
#include "models/patterns.h"
#include "models/shapes.h"
#include "scene/error.h"
#include "scene/json_depth.h"

namespace enfilade {
namespace {

constexpr double kTurn = 360;        // the largest turn either way [degrees]
constexpr double kSameLevel = 1e-3;  // [m]

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

glm::dvec3 parseColor(const JsonView& json) {
  const std::string text = json.text();
  const bool hex = text.size() == 7 && text[0] == '#' &&
                   text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!hex) json.fail("must be a colour such as \"#a0522d\"");
  const unsigned long value = std::stoul(text.substr(1), nullptr, 16);
  return glm::dvec3(value >> 16 & 255, value >> 8 & 255, value & 255) / 255.0;
}

PlanFinish parseFinish(const std::string& name, const JsonView& json) {
  json.allowOnly({"pattern", "colors", "size", "seed", "double_sided", "unlit"});
  PlanFinish finish;
  finish.name = name;
  finish.pattern = json.textAt("pattern", "plain");
  if (!isPattern(finish.pattern))
    json.at("pattern").fail("no pattern is called that; there are: " + listed(patternNames()));
  for (const JsonView& color : json.itemsAt("colors")) finish.colors.push_back(parseColor(color));
  if (finish.colors.empty()) json.at("colors").fail("needs at least one colour");
  finish.size = json.numberAt("size", 0.01, 1000, 1);
  finish.seed = static_cast<std::uint32_t>(json.numberAt("seed", 0, 1e9, 0));
  finish.double_sided = json.flagAt("double_sided", false);
  finish.unlit = json.flagAt("unlit", false);
  return finish;
}

glm::dvec3 parsePlace(const JsonView& json) {
  const auto xyz = json.items();
  if (xyz.size() != 3) json.fail("must be [x, y, z]");
  glm::dvec3 place(0);
  for (int i = 0; i < 3; ++i) place[i] = xyz[static_cast<std::size_t>(i)].number(-1000, 1000);
  return place;
}

PlanLight parseLight(const JsonView& json) {
  json.allowOnly({"at", "color", "candela"});
  PlanLight light;
  light.at = parsePlace(json.at("at"));
  if (json.has("color")) light.color = parseColor(json.at("color"));
  light.candela = json.numberAt("candela", 0, 1e6);
  return light;
}

PlanPart parsePart(const JsonView& json) {
  PlanPart part;
  part.shape = json.textAt("shape");
  const ShapeKind* kind = findShape(part.shape);
  if (kind == nullptr)
    json.at("shape").fail("no shape is called that; there are: " + listed(shapeNames()));
  part.finish = json.textAt("finish");
  part.turn = json.numberAt("turn", -kTurn, kTurn, 0);
  part.detail = json.numberAt("detail", 0.01, 100, 1);
  if (json.has("at")) part.at = parsePlace(json.at("at"));
  for (const ShapeParameter& p : kind->parameters) part.numbers[p.name] = p.fallback;
  for (const auto& [key, value] : json.members()) {
    if (key == "shape" || key == "finish" || key == "turn" || key == "detail" || key == "at" ||
        key == "light")
      continue;
    const ShapeParameter* parameter = kind->find(key);
    if (parameter == nullptr) json.fail(fmt::format("{} has no \"{}\"", part.shape, key));
    part.numbers[key] = value.number(parameter->least, parameter->most);
  }
  return part;
}

PlanPiece parsePiece(const std::string& name, const JsonView& json) {
  PlanPiece piece{name, {}, {}, glm::dvec3(0), {}};
  if (json.has("light")) piece.light = parseLight(json.at("light"));
  if (json.has("furniture")) {
    json.allowOnly({"furniture", "width", "height", "depth", "light"});
    piece.furniture = json.textAt("furniture");
    piece.size = {json.numberAt("width", 0.01, 100, 0), json.numberAt("height", 0.01, 100, 0),
                  json.numberAt("depth", 0.01, 100, 0)};
  } else if (json.has("parts")) {
    json.allowOnly({"parts", "light"});
    for (const JsonView& part : json.itemsAt("parts")) {
      if (part.has("light")) part.at("light").fail("belongs to the piece, not to a part");
      piece.parts.push_back(parsePart(part));
    }
    if (piece.parts.empty()) json.at("parts").fail("needs at least one part");
  } else {
    piece.parts.push_back(parsePart(json));
  }
  return piece;
}

PlanWall parseWall(const JsonView& json, double fallback_thickness) {
  json.allowOnly({"from", "to", "thickness"});
  PlanWall wall{json.pointAt("from"), json.pointAt("to"),
                json.numberAt("thickness", 0.05, 2, fallback_thickness)};
  if (glm::distance(wall.from, wall.to) < 0.1) json.fail("is shorter than 0.1 m");
  return wall;
}

PlanRoom parseRoom(const JsonView& json, const PlanRoom& defaults) {
  json.allowOnly({"name", "at", "height", "floor", "walls", "ceiling", "trim"});
  PlanRoom room;
  room.name = json.textAt("name");
  if (room.name == kOutsideName) json.at("name").fail("is the name of what lies outside");
  room.at = json.pointAt("at");
  room.height = json.numberAt("height", 2, 20, defaults.height);
  room.floor = json.textAt("floor");
  room.walls = json.textAt("walls");
  room.ceiling = json.textAt("ceiling", defaults.ceiling);
  room.trim = json.textAt("trim", defaults.trim);
  return room;
}

OpeningKind parseKind(const JsonView& json) {
  const std::string kind = json.text();
  if (kind == "door") return OpeningKind::kDoor;
  if (kind == "window") return OpeningKind::kWindow;
  if (kind == "opening") return OpeningKind::kOpening;
  json.fail("must be door, window or opening");
}

PlanOpening parseOpening(const JsonView& json) {
  json.allowOnly({"kind", "between", "at", "width", "sill", "head", "panes"});
  PlanOpening opening;
  opening.kind = parseKind(json.at("kind"));
  const auto between = json.itemsAt("between");
  if (between.size() != 2) json.at("between").fail("must name two rooms, or a room and exterior");
  opening.between = {between[0].text(), between[1].text()};
  if (opening.between[0] == kOutsideName)
    json.at("between").fail("must begin with a room, not the exterior");
  opening.at = json.pointAt("at");
  opening.width = json.numberAt("width", 0.2, 20);
  opening.sill = json.numberAt("sill", 0, 20, 0);
  opening.head = json.numberAt("head", 0.2, 20);
  if (opening.head < opening.sill + 0.2) json.at("head").fail("must be 0.2 m above the sill");
  if (json.has("panes")) {
    const auto panes = json.at("panes").items();
    if (panes.size() != 2) json.at("panes").fail("must be [across, up]");
    opening.panes = {panes[0].number(1, 12), panes[1].number(1, 12)};
  }
  return opening;
}

PlanFitting parseFitting(const JsonView& json) {
  json.allowOnly({"piece", "on", "room", "at", "height", "turn", "scale", "on_wall"});
  PlanFitting fitting;
  fitting.piece = json.textAt("piece");
  if (json.has("on")) fitting.on = json.textAt("on");
  fitting.room = json.textAt("room");
  fitting.at = json.pointAt("at");
  fitting.height = json.numberAt("height", 0, 20, 0);
  fitting.turn = json.numberAt("turn", -kTurn, kTurn, 0);
  fitting.scale = json.numberAt("scale", 0.01, 100, 1);
  fitting.on_wall = json.flagAt("on_wall", false);
  return fitting;
}

PlanWell parseWell(const JsonView& json) {
  json.allowOnly({"between", "from", "to"});
  PlanWell well;
  const auto between = json.itemsAt("between");
  if (between.size() != 2) json.at("between").fail("must name two rooms, the upper one first");
  well.between = {between[0].text(), between[1].text()};
  const glm::dvec2 from = json.pointAt("from"), to = json.pointAt("to");
  well.low = glm::min(from, to);
  well.high = glm::max(from, to);
  if (well.high.x - well.low.x < 0.3 || well.high.y - well.low.y < 0.3)
    json.fail("is narrower than 0.3 m");
  return well;
}

PlanRoom parseDefaults(const JsonView& storey) {
  PlanRoom defaults;
  if (!storey.has("defaults")) return defaults;
  const JsonView json = storey.at("defaults");
  json.allowOnly({"height", "ceiling", "trim"});
  defaults.height = json.numberAt("height", 2, 20, defaults.height);
  defaults.ceiling = json.textAt("ceiling", "");
  defaults.trim = json.textAt("trim", "");
  return defaults;
}

/// `below`: null for the lowest.
PlanStorey parseStorey(const JsonView& json, const PlanStorey* below) {
  json.allowOnly({"name", "floor", "height", "wall_thickness", "defaults", "walls", "solids",
                  "rooms", "openings", "wells", "fittings"});
  PlanStorey storey;
  storey.name = json.textAt("name", below == nullptr ? "ground" : "upper");
  storey.floor = json.numberAt("floor", -100, 1000, below == nullptr ? 0 : below->top());
  if (below != nullptr && std::abs(storey.floor - below->top()) > kSameLevel)
    json.at("floor").fail(fmt::format("must be {}, where the storey below ends", below->top()));
  storey.height = json.numberAt("height", 2, 40);
  const double thickness = json.numberAt("wall_thickness", 0.05, 2, 0.25);
  const PlanRoom defaults = parseDefaults(json);
  for (const JsonView& wall : json.itemsAt("walls"))
    storey.walls.push_back(parseWall(wall, thickness));
  for (const JsonView& solid : json.itemsAt("solids", false)) {
    solid.allowOnly({"at"});
    storey.solids.push_back(solid.pointAt("at"));
  }
  for (const JsonView& room : json.itemsAt("rooms"))
    storey.rooms.push_back(parseRoom(room, defaults));
  for (const JsonView& opening : json.itemsAt("openings", false))
    storey.openings.push_back(parseOpening(opening));
  for (const JsonView& well : json.itemsAt("wells", false)) storey.wells.push_back(parseWell(well));
  for (const JsonView& fitting : json.itemsAt("fittings", false))
    storey.fittings.push_back(parseFitting(fitting));
  return storey;
}

void parseOutside(const JsonView& json, FloorPlan& plan) {
  json.allowOnly({"ground", "margin", "facade", "roof", "floor", "trim"});
  plan.ground = json.numberAt("ground", -100, plan.storeys[0].floor, plan.storeys[0].floor);
  plan.margin = json.numberAt("margin", 1, 1000, plan.margin);
  plan.facade = json.textAt("facade");
  plan.roof = json.textAt("roof");
  plan.ground_finish = json.textAt("floor");
  plan.outside_trim = json.textAt("trim");
}

}  // namespace

bool FloorPlan::hasFurniture() const {
  return std::any_of(pieces.begin(), pieces.end(),
                     [](const auto& named) { return !named.second.furniture.empty(); });
}

FloorPlan parseFloorPlan(const std::string& json_text, const std::string& subject) {
  requireShallowJson(json_text, subject);
  nlohmann::json document;
  try {
    document = nlohmann::json::parse(json_text);
  } catch (const nlohmann::json::exception& e) {
    // "[json.exception.parse_error.101] parse error at line 1, column 9: …"
    const std::string what = e.what();
    throw Error(ErrorKind::kBadInput, subject, "is not JSON: " + what.substr(what.find(' ') + 1));
  }
  const JsonView json(document, subject);
  json.allowOnly({"enfilade", "version", "name", "copyright", "triangles", "bake_light", "storeys",
                  "outside", "pieces", "finishes"});
  if (json.textAt("enfilade") != "plan") json.at("enfilade").fail("must be \"plan\"");
  json.numberAt("version", 1, 1);
  FloorPlan plan;
  plan.name = json.textAt("name");
  plan.copyright = json.textAt("copyright", plan.name);
  plan.triangles = static_cast<std::uint64_t>(json.numberAt("triangles", 0, 1e8, 150000));
  plan.bake_light = json.flagAt("bake_light", false);
  for (const auto& [name, finish] : json.at("finishes").members())
    plan.finishes[name] = parseFinish(name, finish);
  for (const auto& [name, piece] : json.at("pieces").members())
    plan.pieces[name] = parsePiece(name, piece);
  for (const JsonView& storey : json.itemsAt("storeys"))
    plan.storeys.push_back(
        parseStorey(storey, plan.storeys.empty() ? nullptr : &plan.storeys.back()));
  if (plan.storeys.empty()) json.at("storeys").fail("must hold at least one storey");
  parseOutside(json.at("outside"), plan);
  checkNames(plan, subject);
  return plan;
}

}  // namespace enfilade
