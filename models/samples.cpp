#include "models/samples.h"

#include <algorithm>
#include <optional>

#include "models/embedded_plans.h"
#include "models/floor_plan.h"
#include "models/raise_building.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {
namespace {

constexpr std::uint64_t kLeast = 50'000, kMost = 10'000'000;

std::string knownNames() {
  std::string names;
  for (const std::string& name : sampleNames()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

std::string textOfFile(const std::string& file) {
  const std::vector<std::uint8_t> bytes = readFile(file, kMostTextBytes);
  return {bytes.begin(), bytes.end()};
}

std::string builtInPlan(const std::string& name) {
  const auto plans = embeddedPlans();
  const auto found = std::find_if(plans.begin(), plans.end(),
                                  [&](const EmbeddedPlan& p) { return p.name == name; });
  if (found == plans.end())
    throw Error(ErrorKind::kUsage, name, "no sample is called that; there are: " + knownNames());
  return found->text;
}

bool isFile(const std::string& name) { return name.ends_with(".json"); }

/// What errors call the plan.
std::string subjectOf(const std::string& name) {
  return isFile(name) ? name : "plans/" + name + ".json";
}

FloorPlan planOf(const std::string& name) {
  return parseFloorPlan(isFile(name) ? textOfFile(name) : builtInPlan(name), subjectOf(name));
}

}  // namespace

std::vector<std::string> sampleNames() {
  std::vector<std::string> names;
  for (const EmbeddedPlan& plan : embeddedPlans()) names.emplace_back(plan.name);
  std::sort(names.begin(), names.end());
  return names;
}

bool wantsBakedLight(const std::string& name) { return planOf(name).bake_light; }

Building raiseSample(const std::string& name, std::uint64_t triangles,
                     const std::string& furniture_folder, bool to_be_lit) {
  if (triangles != 0 && (triangles < kLeast || triangles > kMost))
    throw Error(ErrorKind::kUsage, name, "triangles must be from 50000 to 10000000");
  const FloorPlan plan = planOf(name);
  std::optional<FurnitureLibrary> library;
  if (plan.hasFurniture()) library.emplace(furniture_folder);
  return raiseBuilding(plan, triangles == 0 ? plan.triangles : triangles, subjectOf(name),
                       library ? &*library : nullptr, to_be_lit);
}

}  // namespace enfilade
