#include "preprocess/make_house.h"

#include "preprocess/authored_diagnosis.h"
#include "preprocess/authored_names.h"
#include "preprocess/bake_light.h"
#include "preprocess/cut_cells.h"
#include "preprocess/given_cells.h"
#include "preprocess/object_roles.h"
#include "preprocess/preprocess_job.h"
#include "preprocess/share_geometry.h"

namespace enfilade {

namespace {

std::map<std::string, double> statisticsOf(const House& house, const Building& model) {
  std::size_t doors = 0;
  for (const ObjectRole role : house.object_roles) doors += role == ObjectRole::kDoor;
  return {{"model_triangles", static_cast<double>(triangleCount(model))},
          {"model_objects", static_cast<double>(model.objects.size())},
          {"objects", static_cast<double>(house.building.objects.size())},
          {"door_objects", static_cast<double>(doors)},
          {"cells", static_cast<double>(house.graph.cells.size())},
          {"portals", static_cast<double>(house.graph.portals.size())}};
}

/// Where the cells come from.
enum class CellSource { kAutomatic, kMixed, kAuthored, kGiven };

CellSource sourceOf(const PreprocessParameters& parameters, bool named, bool given) {
  if (given) return CellSource::kGiven;
  if (!named || parameters.automatic) return CellSource::kAutomatic;
  return parameters.named_only ? CellSource::kAuthored : CellSource::kMixed;
}

CellProposal proposeCells(CellSource source, const Building& model,
                          std::span<const ObjectRole> roles, const VoxelGrid& voxels,
                          const AuthoredNames& names, const std::optional<GivenGraph>& given,
                          const CellParameters& parameters) {
  switch (source) {
    case CellSource::kGiven:
      return givenCells(*given, voxels);
    case CellSource::kAuthored:
      return authoredCells(names, voxels);
    case CellSource::kMixed:
      return findCells(model, roles, voxels, parameters, &names);
    default:
      return findCells(model, roles, voxels, parameters);
  }
}

/// Light passes doors, which stand open, and windows.
void lightModel(Building& model, const CutCells& cells, std::span<const ObjectRole> roles,
                const PreprocessParameters& parameters, const Stages& stages) {
  std::vector<std::uint8_t> clear;
  for (const ObjectRole role : roles) clear.push_back(role != ObjectRole::kFixed ? 1 : 0);
  LightParameters light;
  light.threads = parameters.threads;
  bakeLight(model, skyPortals(cells.graph), clear, light,
            [&](const std::string& stage, double done) {
              if (done < 1) stages.tell(stage, done);
            });
}

}  // namespace

House makeHouse(Building model, const PreprocessParameters& parameters,
                const std::optional<GivenGraph>& given, const Stages& stages) {
  const AuthoredNames names = takeAuthoredNames(model);
  std::vector<ObjectRole> roles = namedRoles(model, parameters.doors, parameters.windows);
  const VoxelGrid voxels =
      stages.run("voxelise", [&] { return voxelise(model, roles, parameters.cells.voxel); });
  const CellSource source = sourceOf(parameters, !names.empty(), given.has_value());
  CutCells cells = stages.run("find cells and portals", [&] {
    return cutCells(voxels,
                    proposeCells(source, model, roles, voxels, names, given, parameters.cells));
  });
  if (source == CellSource::kAuthored || source == CellSource::kMixed) {
    diagnoseAuthored(names, voxels, cells);
  }
  if (source == CellSource::kGiven) compareWithGiven(*given, cells);
  fixDoorsWithoutPortals(model, cells, roles);
  if (parameters.bake_light) {
    stages.run(kLightStage, [&] { lightModel(model, cells, roles, parameters, stages); });
  }
  SharedGeometry shared = stages.run("share out the geometry", [&] {
    const Patches patches = makePatches(model);
    PatchCells claims = claimByTouch(model, patches, voxels, cells);
    claimBySight(
        model, roles, patches, cells, parameters.rays_per_cell, parameters.threads,
        [&](double done) { stages.tell("share out the geometry", done); }, claims);
    return splitByCells(model, roles, patches, claims);
  });
  House house;
  house.graph = std::move(cells.graph);
  house.grid = std::move(cells.grid);
  house.info.log = std::move(cells.log);
  house.info.leaks = std::move(cells.leaks);
  house.building = std::move(shared.building);
  house.object_roles = std::move(shared.roles);
  house.object_cells = std::move(shared.cells);
  house.switch_distance = parameters.image.switch_distance;
  house.eye_height = parameters.eye_height;
  house.info.parameters = parameterTexts(parameters);
  constexpr const char* kSources[] = {"automatic", "mixed", "authored", "given"};
  house.info.parameters["cells"] = kSources[static_cast<int>(source)];
  if (given) house.info.parameters["graph_sha256"] = given->sha256;
  house.info.statistics = statisticsOf(house, model);
  return house;
}

}  // namespace enfilade
