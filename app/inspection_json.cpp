#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/inspection.h"
#include "app/portal_size.h"
#include "portals/house_names.h"

namespace enfilade {

namespace {

using Json = nlohmann::ordered_json;

/// To a tenth of a millimetre: a float's own digits beyond that read badly.
double tidy(float value) { return std::round(static_cast<double>(value) * 1e4) / 1e4; }

Json vectorJson(const glm::vec3& v) { return {tidy(v.x), tidy(v.y), tidy(v.z)}; }

Json boxJson(const Box& box) {
  if (box.empty()) return nullptr;
  return {{"min", vectorJson(box.min)}, {"max", vectorJson(box.max)}};
}

Json buildingJson(const BuildingFacts& f) {
  Json json{{"triangles", f.triangles},
            {"objects", f.objects},
            {"meshes", f.meshes},
            {"closed_meshes", f.closed_meshes},
            {"nodes", f.nodes},
            {"materials",
             {{"count", f.materials},
              {"masked", f.masked},
              {"blended", f.blended},
              {"double_sided", f.double_sided}}},
            {"images", {{"count", f.images}, {"pixels", f.image_pixels}}},
            {"bounds", boxJson(f.bounds)},
            {"rooms_named", f.rooms_named},
            {"portals_named", f.portals_named}};
  json["node_kinds"] = Json::object();
  for (const auto& [name, count] : f.kinds) json["node_kinds"][name] = count;
  return json;
}

Json storeysJson(const CellGraph& graph) {
  Json json = Json::array();
  for (const Storey& storey : graph.storeys) {
    json.push_back({{"name", storey.name}, {"floor_y", tidy(storey.floor_y)}});
  }
  return json;
}

Json cellsJson(const CellGraph& graph) {
  Json json = Json::array();
  for (std::size_t c = 0; c < graph.cells.size(); ++c) {
    const Cell& cell = graph.cells[c];
    json.push_back({{"id", c},
                    {"name", cell.name},
                    {"exterior", c == kExterior},
                    {"storey", cell.storey},
                    {"floor_area_m2", tidy(cell.floor_area)},
                    {"volume_m3", tidy(cell.volume)},
                    {"bounds", boxJson(cell.bounds)},
                    {"portals", cell.portals}});
  }
  return json;
}

Json portalsJson(const CellGraph& graph) {
  Json json = Json::array();
  for (std::size_t p = 0; p < graph.portals.size(); ++p) {
    const Portal& portal = graph.portals[p];
    const glm::vec2 size = portalSize(portal);
    Json polygon = Json::array();
    for (const glm::vec3& corner : portal.polygon) polygon.push_back(vectorJson(corner));
    json.push_back({{"id", p},
                    {"name", portal.name},
                    {"kind", kindName(portal.kind)},
                    {"front", portal.front},
                    {"back", portal.back},
                    {"width_m", tidy(size.x)},
                    {"height_m", tidy(size.y)},
                    {"area_m2", tidy(portal.area())},
                    {"two_way", portal.two_way},
                    {"active", portal.active},
                    {"polygon", polygon}});
  }
  return json;
}

Json layerJson(const std::vector<std::size_t>& samples) {
  const std::size_t sum = std::accumulate(samples.begin(), samples.end(), std::size_t{0});
  Json percent = Json::array();
  for (const std::size_t count : samples) {
    percent.push_back(100.0 * static_cast<double>(count) / static_cast<double>(sum));
  }
  return {{"samples", sum}, {"per_layer", samples}, {"percent", percent}};
}

Json layersJson(const std::vector<SideLayers>& sides) {
  Json json{{"all", layerJson(samplesInAll(sides))}, {"sides", Json::array()}};
  for (const SideLayers& side : sides) {
    Json one{{"portal", side.portal}, {"side", side.from_front ? "front" : "back"}};
    one.update(layerJson(side.samples));
    json["sides"].push_back(one);
  }
  return json;
}

std::string dumped(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string modelJson(const std::string& file, const Building& building,
                      const std::vector<std::string>& warnings) {
  const BuildingFacts facts = describeBuilding(building);
  std::vector<std::string> problems = buildingProblems(facts);
  problems.insert(problems.begin(), warnings.begin(), warnings.end());
  return dumped({{"schema", 1},
                 {"kind", "model"},
                 {"file", file},
                 {"copyright", building.copyright},
                 {"building", buildingJson(facts)},
                 {"problems", problems}});
}

std::string houseJson(const std::string& folder, const House& house, const ImageCounts& images,
                      const std::vector<SideLayers>& layers) {
  Json json{
      {"schema", 1},
      {"kind", "house"},
      {"folder", folder},
      {"model", {{"name", house.info.model_name}, {"sha256", house.info.model_sha256}}},
      {"tool_version", house.info.tool_version},
      {"building", buildingJson(describeBuilding(house.building))},
      {"storeys", storeysJson(house.graph)},
      {"cells", cellsJson(house.graph)},
      {"portals", portalsJson(house.graph)},
      {"image_sides", images.sides},
      {"portal_images",
       {{"textures", images.textures}, {"references", images.references}, {"ldis", images.ldis}}},
      {"switch_distance_m", tidy(house.switch_distance)},
      {"eye_height_m", tidy(house.eye_height)},
      {"parameters", house.info.parameters},
      {"statistics", house.info.statistics},
      {"log", house.info.log},
      {"problems", houseProblems(house)}};
  if (!layers.empty()) json["layers"] = layersJson(layers);
  return dumped(json);
}

}  // namespace enfilade
