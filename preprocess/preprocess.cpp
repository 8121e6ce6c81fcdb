#include "preprocess/preprocess.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "ibr/capture_plan.h"
#include "portals/leaf_cover.h"
#include "preprocess/authored_diagnosis.h"
#include "preprocess/authored_names.h"
#include "preprocess/bake_images.h"
#include "preprocess/bake_light.h"
#include "preprocess/cut_cells.h"
#include "preprocess/given_cells.h"
#include "preprocess/house_folder.h"
#include "preprocess/object_roles.h"
#include "preprocess/share_geometry.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/model_reader.h"

namespace enfilade {

namespace {

// Times the stages and tells of their progress.
class Stages {
 public:
  Stages(const ProgressSink& sink, std::vector<StageTime>& times) : sink_(sink), times_(times) {}

  template <class Work>
  auto run(const std::string& stage, Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    tell(stage, 0);
    const auto note = [&] {
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      times_.push_back({stage, taken.count()});
      tell(stage, 1);
    };
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      note();
    } else {
      auto result = work();
      note();
      return result;
    }
  }
  void tell(const std::string& stage, double done) const {
    if (sink_) sink_(stage, done);
  }

 private:
  const ProgressSink& sink_;
  std::vector<StageTime>& times_;
};

std::map<std::string, std::string> parameterTexts(const PreprocessParameters& p) {
  const auto number = [](auto value) { return fmt::format("{}", value); };
  std::map<std::string, std::string> texts = imageParameterTexts(p.image);
  texts.insert({{"doors", p.doors},
                {"windows", p.windows},
                {"automatic", p.automatic ? "true" : "false"},
                {"named_only", p.named_only ? "true" : "false"},
                {"images", p.images ? "true" : "false"},
                {"bake_light", p.bake_light ? "true" : "false"},
                {"gl", glBackendName(p.gl)},
                {"voxel_m", number(p.cells.voxel)},
                {"slice_height_m", number(p.cells.slice_height)},
                {"lintel_radius_m", number(p.cells.lintel_radius)},
                {"lintel_head_m", number(p.cells.lintel_head)},
                {"merge_ratio", number(p.cells.merge_ratio)},
                {"smallest_room_m2", number(p.cells.smallest_room)},
                {"smallest_door_m", number(p.cells.smallest_door)},
                {"eye_height_m", number(p.eye_height)},
                {"rays_per_cell", number(p.rays_per_cell)}});
  return texts;
}

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

House makeHouse(Building model, const PreprocessParameters& parameters,
                const std::optional<GivenGraph>& given, Stages& stages) {
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
  lookThroughShutPortals(house, doorLeaves(house));
  house.switch_distance = parameters.image.switch_distance;
  house.eye_height = parameters.eye_height;
  house.info.parameters = parameterTexts(parameters);
  constexpr const char* kSources[] = {"automatic", "mixed", "authored", "given"};
  house.info.parameters["cells"] = kSources[static_cast<int>(source)];
  if (given) house.info.parameters["graph_sha256"] = given->sha256;
  house.info.statistics = statisticsOf(house, model);
  return house;
}

/// The graph that is to be taken, which preprocessing must not replace.
std::optional<GivenGraph> takeGivenGraph(const std::string& folder,
                                         PreprocessParameters& parameters) {
  if (parameters.graph.empty()) return std::nullopt;
  GivenGraph given = readGivenGraph(parameters.graph);
  std::error_code ignored;
  if (std::filesystem::equivalent(parameters.graph, houseJsonFile(folder), ignored)) {
    throw Error(ErrorKind::kUsage, parameters.graph,
                "would be replaced: choose another folder for the new house");
  }
  if (parameters.doors == kUsualDoors) parameters.doors = given.doors;
  if (parameters.windows == kUsualWindows) parameters.windows = given.windows;
  return given;
}

}  // namespace

PreprocessResult preprocessBuilding(const std::string& model_file, const std::string& folder,
                                    const PreprocessParameters& asked,
                                    const ProgressSink& progress) {
  PreprocessParameters parameters = asked;
  const std::optional<GivenGraph> given = takeGivenGraph(folder, parameters);
  std::unique_ptr<tbb::global_control> limit;
  if (parameters.threads > 0) {
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(parameters.threads));
  }
  PreprocessResult result;
  Stages stages(progress, result.stages);
  Building model = stages.run("read the model", [&] { return readModel(model_file); });
  HouseFolder output(folder);
  result.house = makeHouse(std::move(model), parameters, given, stages);
  result.house.info.tool_version = ENFILADE_VERSION;
  result.house.info.model_name = std::filesystem::path(model_file).filename().string();
  result.house.info.model_sha256 = sha256Hex(readFile(model_file));
  output.clear();
  if (parameters.images) {
    const std::string stage = "bake the portals' images";
    const BakedImages baked = stages.run(stage, [&] {
      return bakeImages(result.house, parameters.image, folder, {parameters.gl, parameters.threads},
                        progress);
    });
    result.images = baked.images;
    result.image_bytes = baked.bytes;
    result.house.info.statistics["images"] = static_cast<double>(baked.images);
    result.house.info.statistics["image_bytes"] = static_cast<double>(baked.bytes);
  }
  stages.run("write the house", [&] { writeHouse(folder, result.house); });
  output.finish();
  return result;
}

}  // namespace enfilade
