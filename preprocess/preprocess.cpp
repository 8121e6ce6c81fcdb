#include "preprocess/preprocess.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "portals/leaf_cover.h"
#include "portals/open_doors.h"
#include "preprocess/bake_images.h"
#include "preprocess/house_folder.h"
#include "preprocess/make_house.h"
#include "preprocess/preprocess_job.h"
#include "preprocess/stages.h"
#include "preprocess/unfinished_house.h"
#include "scene/error.h"
#include "scene/extent_doubts.h"
#include "scene/file_io.h"
#include "scene/model_reader.h"

namespace enfilade {

namespace {

/// Throws Error (kUsage) if the model stands where the house would put its own.
void refuseToReplace(const std::string& model_file, const std::string& folder) {
  std::error_code ignored;
  if (std::filesystem::equivalent(model_file, geometryFile(folder), ignored)) {
    throw Error(ErrorKind::kUsage, model_file,
                "would be replaced: choose another folder for the house");
  }
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

void describeModel(const std::string& model_file, const std::string& sha256, HouseInfo& info) {
  info.tool_version = ENFILADE_VERSION;
  info.model_name = std::filesystem::path(model_file).filename().string();
  info.model_sha256 = sha256;
}

/// What looks wrong with the model, before the long work.
void tellDoubts(const Building& model, const PreprocessListener& listener) {
  if (!listener.note) return;
  for (const std::string& doubt : extentDoubts(worldBounds(model))) {
    listener.note(fmt::format("note: {} is {}", model.name, doubt));
  }
}

/// Bakes what images the house in `folder` has not yet.
void bake(const PreprocessParameters& parameters, const std::string& folder,
          const PreprocessListener& listener, const Stages& stages, PreprocessResult& result) {
  House& house = result.house;
  lookThroughShutPortals(house, doorLeaves(house));
  const BakedImages baked = stages.run(kBakingStage, [&] {
    return bakeImages(house, parameters.image, folder,
                      {parameters.gl, parameters.threads, listener.checkpoint, listener.sides},
                      listener.progress);
  });
  result.images = baked.images;
  result.image_bytes = baked.bytes;
  house.info.statistics["images"] = static_cast<double>(baked.images);
  house.info.statistics["image_bytes"] = static_cast<double>(baked.bytes);
}

void fillFromFinished(House house, PreprocessResult& result) {
  const auto count = [&](const char* name) {
    const auto entry = house.info.statistics.find(name);
    return entry == house.info.statistics.end() ? 0.0 : entry->second;
  };
  result.images = static_cast<std::size_t>(count("images"));
  result.image_bytes = static_cast<std::uint64_t>(count("image_bytes"));
  result.house = std::move(house);
}

/// What was found is kept before the images are baked, and each portal side when it is.
void makeIn(const HouseFolder& output, const std::string& model_file,
            const PreprocessParameters& parameters, const std::optional<GivenGraph>& given,
            const PreprocessListener& listener, PreprocessResult& result) {
  const Stages stages(listener.progress, result.stages);
  Building model = stages.run("read the model", [&] { return readModel(model_file); });
  const std::string sha256 = sha256Hex(readFile(model_file));
  UnfinishedHouse work(output.path(), describeJob(model_file, sha256, model, parameters, given));
  if (std::optional<House> finished = work.takeUpFinished()) {
    fillFromFinished(std::move(*finished), result);
    return;
  }
  std::optional<House> house = work.takeUp(listener.note);
  tellDoubts(model, listener);
  if (house) {
    if (listener.note) listener.note("goes on: " + describeUnfinished(output.path()));
  } else {
    House made = makeHouse(std::move(model), parameters, given, stages);
    describeModel(model_file, sha256, made.info);
    house = stages.run("write the house", [&] { return work.write(made); });
  }
  if (listener.note && house->graph.cells.size() == 1) {
    listener.note(fmt::format("note: {}", kNoRoom));
  }
  for (const PortalId p : shutWithoutDoor(*house)) {
    if (listener.note) {
      listener.note(fmt::format("note: no door stands in portal {} ({}): {}", p,
                                house->graph.portals[p].name, kShutWithoutDoor));
    }
  }
  result.house = std::move(*house);
  if (parameters.images) bake(parameters, work.path(), listener, stages, result);
  work.finish(result.house);
}

}  // namespace

PreprocessResult preprocessBuilding(const std::string& model_file, const std::string& folder,
                                    const PreprocessParameters& asked,
                                    const PreprocessListener& listener) {
  PreprocessParameters parameters = asked;
  refuseToReplace(model_file, folder);
  const std::optional<GivenGraph> given = takeGivenGraph(folder, parameters);
  std::unique_ptr<tbb::global_control> limit;
  if (parameters.threads > 0) {
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(parameters.threads));
  }
  const HouseFolder output(folder);
  PreprocessResult result;
  try {
    makeIn(output, model_file, parameters, given, listener, result);
  } catch (const Error& error) {
    const std::string kept = describeUnfinished(folder);
    if (error.kind() != ErrorKind::kMachine || kept.empty()) throw;
    throw Error(error.kind(), "", error.what() + ("; " + kept) + kHowToGoOn);
  }
  return result;
}

}  // namespace enfilade
