#include "models/furniture_library.h"
#include "models/plan_layout.h"
#include "tests/fuzz/containers.h"
#include "tests/fuzz/soundness.h"

namespace enfilade::fuzz {
namespace {

std::vector<std::uint8_t> catalogueOf(Bytes input) {
  if (!input.empty() && input.front() == 'P' && input.size() > 4 && input[1] == 'K') {
    return {input.begin(), input.end()};
  }
  const Bytes properties = takePart(input);
  const Bytes model = takePart(input);
  return zipOf({{"PluginFurnitureCatalog.properties", properties},
                {"a/chair.obj", model},
                {"a/chair.mtl", input}});
}

}  // namespace

void plan(Bytes input) {
  const FloorPlan read = parseFloorPlan(textOf(input), "plan.json");
  const std::vector<Layout> storeys = layOut(read, "plan.json");
  require(storeys.size() == read.storeys.size(), "a layout for each storey");
  for (std::size_t s = 0; s < storeys.size(); ++s) {
    require(storeys[s].rooms.size() == read.storeys[s].rooms.size(), "an outline for each room");
  }
}

void catalogue(Bytes input) {
  const FurnitureLibrary library(catalogueOf(input), "furniture.sh3f");
  for (const auto& [id, entry] : library.entries()) requireSound(library.load(entry));
}

}  // namespace enfilade::fuzz
