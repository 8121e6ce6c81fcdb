#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/console.h"
#include "app/help_format.h"
#include "app/output_guard.h"
#include "app/progress.h"
#include "models/samples.h"
#include "preprocess/bake_light.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/gltf_writer.h"
#include "scene/printable.h"

namespace enfilade {

namespace {

namespace fs = std::filesystem;

struct SampleOptions {
  std::string name;
  std::string output;
  std::string furniture = kFurnitureFolder;
  std::uint64_t triangles = 0;
  std::optional<bool> bake_light;  ///< none: as the plan says
};

/// The credits of what the building is made of, a line each; empty if it owes none.
std::string creditsOf(const std::string& copyright) {
  std::string text;
  if (copyright.find("; ") == std::string::npos) return text;
  for (std::size_t at = 0; at < copyright.size();) {
    const std::size_t end = std::min(copyright.find("; ", at), copyright.size());
    text += printable(copyright.substr(at, end - at)) + "\n";
    at = end + 2;
  }
  return text;
}

/// Where they stand: beside the model.
std::string creditsFile(const std::string& model_file) {
  const fs::path model(model_file);
  return (model.parent_path() / (model.stem().string() + ".credits.txt")).string();
}

/// Throws Error (kUsage) if a file of that name is there, but not the model that it would be of.
void refuseForeignCredits(const std::string& model_file) {
  std::error_code ignored;
  const std::string file = creditsFile(model_file);
  if (!fs::exists(file, ignored) || fs::exists(model_file, ignored)) return;
  throw Error(ErrorKind::kUsage, file,
              "is there already, and would be replaced by the credits of what is in " + model_file +
                  "; name another file to write");
}

void runSample(const SampleOptions& options, bool quiet) {
  refuseToReplace(options.output, options.name);
  const bool lit = options.bake_light.value_or(wantsBakedLight(options.name));
  Building building = raiseSample(options.name, options.triangles, options.furniture, lit);
  const std::string credits = creditsOf(building.copyright);
  if (!credits.empty()) refuseForeignCredits(options.output);
  if (lit) {
    LightParameters light;
    light.longest_edge = 0;  // split already, within the number of triangles
    ProgressPrinter progress(quiet);
    bakeNamedLight(building, light, progress.sink());
  }
  writeGlb(options.output, building);
  if (!credits.empty()) writeFileAtomically(creditsFile(options.output), credits);
  printNote(quiet, fmt::format("{}: {} triangles, {} objects", options.output,
                               triangleCount(building), building.objects.size()));
}

}  // namespace

void addSampleCommand(CLI::App& program, CommandContext& context) {
  auto options = std::make_shared<SampleOptions>();
  CLI::App* command =
      addCommand(program, "sample", "Raise a built-in building and write it as GLB",
                 "enfilade sample gallery -o gallery.glb --triangles 500000", context.quiet);
  command
      ->add_option(
          "NAME", options->name,
          fmt::format("Which building: {}; or a floor plan of yours, a .json as models/README.md "
                      "describes it",
                      fmt::join(sampleNames(), ", ")))
      ->required();
  command->add_option("-o,--output", options->output, "The GLB file to write")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--furniture", options->furniture,
                   "Where Sweet Home 3D's catalogues (.sh3f) are, for plans with furniture")
      ->type_name("FOLDER")
      ->check(notEmpty())
      ->capture_default_str();
  command
      ->add_option(
          "--triangles", options->triangles,
          "About how many triangles, 50000 to 10000000; the sample's own number without it")
      ->type_name("N")
      ->check(limits(50e3, 10e6));
  command->add_flag_function(
      "--bake-light,!--no-bake-light",
      [options](std::int64_t count) { options->bake_light = count > 0; },
      "Light the rooms as the sky through the windows and the lamps would, with "
      "diffuse reflections; without either as the plan says (brooks and haunted are lit)");
  command->callback([options, &context] {
    context.run = [options, &context] { runSample(*options, context.quiet); };
  });
}

}  // namespace enfilade
