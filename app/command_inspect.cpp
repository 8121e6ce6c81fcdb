#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/floor_plan.h"
#include "app/help_format.h"
#include "app/inspection.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/gltf_reader.h"

namespace enfilade {

namespace {

struct InspectOptions {
  std::string input;
  std::string plan;
  bool json = false;
};

void inspectHouse(const InspectOptions& options, bool quiet) {
  const House house = readHouse(options.input);
  const ImageCounts images = countImages(house, options.input);
  if (!options.plan.empty()) {
    writeFileAtomically(options.plan, floorPlanSvg(house));
    printNote(quiet, options.plan + ": the floor plan");
  }
  printResult(options.json ? houseJson(options.input, house, images)
                           : houseText(options.input, house, images));
}

void inspectModel(const InspectOptions& options) {
  if (!options.plan.empty()) {
    throw Error(ErrorKind::kUsage, options.input,
                "a model has no rooms yet; preprocess it, then inspect the house with --plan");
  }
  Warnings warnings;
  const Building building = readGltf(options.input, &warnings);
  printResult(options.json ? modelJson(options.input, building, warnings)
                           : modelText(options.input, building, warnings));
}

void runInspect(const InspectOptions& options, bool quiet) {
  // A folder is meant as a house, so that its reader says what is wrong with it.
  if (std::filesystem::is_directory(options.input)) {
    inspectHouse(options, quiet);
  } else {
    inspectModel(options);
  }
}

}  // namespace

void addInspectCommand(CLI::App& program, CommandContext& context) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command =
      addCommand(program, "inspect", "Say what is in a model or a house, and what looks wrong",
                 "enfilade inspect house --plan plan.svg", context.quiet);
  command->add_option("MODEL|HOUSE", options->input, "A .glb or .gltf file, or a house folder")
      ->required();
  command->add_flag("--json", options->json, "Print JSON");
  command
      ->add_option("--plan", options->plan,
                   "Draw the floor plan of a house, storey by storey: cells coloured and named, "
                   "portals marked")
      ->type_name("FILE.svg");
  command->callback([options, &context] {
    context.run = [options, &context] { runInspect(*options, context.quiet); };
  });
}

}  // namespace enfilade
