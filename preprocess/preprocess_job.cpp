#include "preprocess/preprocess_job.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "ibr/ldi_file.h"
#include "portals/grid_file.h"
#include "portals/house_json.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/gltf_writer.h"

namespace enfilade {

namespace {

std::string checksumOf(std::span<const std::uint8_t> bytes) {
  return checksumText(fileChecksum(bytes));
}

/// Two builds of one version may bake other bytes.  Empty where the system does not show it.
std::string checksumOfProgram() {
  try {
    return checksumOf(readFile("/proc/self/exe"));
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

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

PreprocessJob describeJob(const std::string& model_file, const std::string& model_sha256,
                          const Building& model, const PreprocessParameters& parameters,
                          const std::optional<GivenGraph>& given) {
  PreprocessJob job = parameterTexts(parameters);
  job["model"] = std::filesystem::path(model_file).filename().string();
  job["model_sha256"] = model_sha256;
  // A model's buffers, materials and pictures may lie in other files.
  job["model_content"] = checksumOf(encodeGlb(model));
  if (given) job["graph_sha256"] = given->sha256;
  if (given && given->grid) job["graph_grid"] = checksumOf(encodeGrid(*given->grid));
  // The bytes that a GPU makes are its own.
  if (parameters.images && parameters.gl == GlBackend::kEgl) {
    job["opengl"] = createGlContext(parameters.gl, 1)->description();
  }
  job["tool_version"] = ENFILADE_VERSION;
  job["program"] = checksumOfProgram();
  job["house_format"] = std::to_string(kHouseFormatVersion);
  job["ldi_format"] = std::to_string(kLdiFileVersion);
  return job;
}

std::string jobText(const PreprocessJob& job) {
  return nlohmann::json(job).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string differenceOfJobs(const std::string& before, const PreprocessJob& job) {
  const auto parsed = nlohmann::json::parse(before, nullptr, false);
  if (!parsed.is_object()) return "its job.json is damaged";
  for (const auto& [name, value] : job) {
    const auto old = parsed.find(name);
    const std::string was = old != parsed.end() && old->is_string() ? old->get<std::string>() : "";
    if (was == value) continue;
    // Checksums say nothing to a person.
    if (name == "program") return "it was begun by another build of enfilade";
    if (name.starts_with("model_")) return "the model has changed";
    return fmt::format("{} was '{}', is '{}'", name, was, value);
  }
  return "it was begun with more";
}

}  // namespace enfilade
