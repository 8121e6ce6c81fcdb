#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/cell_solids.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/floor_plan.h"
#include "app/help_format.h"
#include "app/inspection.h"
#include "app/output_guard.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/gltf_writer.h"
#include "scene/model_reader.h"

namespace enfilade {

namespace {

struct InspectOptions {
  std::string input;
  std::string plan;
  std::string cells;   ///< a GLB
  std::string layers;  ///< a folder for their pictures
  int portal = -1;     ///< any
  std::string side;    ///< either
  bool json = false;
};

/// Writes the pictures that --layers asks for.
std::vector<SideLayers> drawLayers(const InspectOptions& options, const House& house, bool quiet) {
  std::vector<SideLayers> sides = countLayers(house, options.input);
  if (sides.empty()) {
    throw Error(ErrorKind::kBadInput, options.input,
                "has no layered depth images; preprocess the model again without --no-images");
  }
  const SideLayers& side = chooseSide(sides, options.portal, options.side);
  const std::size_t pictures = writeLayerPictures(house, options.input, side, options.layers);
  printNote(quiet, fmt::format("{}: {} layers of portal {} as seen from its {}", options.layers,
                               pictures, side.portal, side.from_front ? "front" : "back"));
  return sides;
}

void inspectHouse(const InspectOptions& options, bool quiet) {
  for (const std::string& output : {options.plan, options.cells, options.layers}) {
    refuseToReplace(output, options.input);
  }
  const House house = readHouse(options.input);
  requireFiles(house, options.input);
  const ImageCounts images = countImages(house);
  if (!options.plan.empty()) {
    writeFileAtomically(options.plan, floorPlanSvg(house));
    printNote(quiet, options.plan + ": the floor plan");
  }
  if (!options.cells.empty()) {
    writeGlb(options.cells, cellSolids(house));
    printNote(quiet, options.cells + ": the cells and portals");
  }
  std::vector<SideLayers> layers;
  if (!options.layers.empty()) layers = drawLayers(options, house, quiet);
  printResult(options.json ? houseJson(options.input, house, images, layers)
                           : houseText(options.input, house, images) +
                                 (layers.empty() ? std::string() : layersText(layers)));
}

void inspectModel(const InspectOptions& options) {
  if (!options.plan.empty()) {
    throw Error(ErrorKind::kUsage, options.input,
                "a model has no rooms yet; preprocess it, then inspect the house with --plan");
  }
  if (!options.cells.empty()) {
    throw Error(ErrorKind::kUsage, options.input,
                "a model has no rooms yet; preprocess it, then inspect the house with --cells");
  }
  if (!options.layers.empty()) {
    throw Error(ErrorKind::kUsage, options.input,
                "a model has no images yet; preprocess it, then inspect the house with --layers");
  }
  Warnings warnings;
  const Building building = readModel(options.input, &warnings);
  printResult(options.json ? modelJson(options.input, building, warnings)
                           : modelText(options.input, building, warnings));
}

void runInspect(const InspectOptions& options, bool quiet) {
  // A folder is meant as a house, so that its reader says what is wrong with it.
  std::error_code ignored;
  if (std::filesystem::is_directory(options.input, ignored)) {
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
  command
      ->add_option("MODEL|HOUSE", options->input, "A .glb, .gltf or .obj file, or a house folder")
      ->required();
  command->add_flag("--json", options->json, "Print JSON");
  command
      ->add_option("--plan", options->plan,
                   "Draw the floor plan of a house, storey by storey: cells coloured and named, "
                   "portals marked")
      ->type_name("FILE.svg")
      ->check(notEmpty());
  command
      ->add_option("--cells", options->cells,
                   "Write the cells and portals of a house as a model, to look at in any viewer")
      ->type_name("FILE.glb")
      ->check(notEmpty());
  CLI::Option* layers =
      command
          ->add_option("--layers", options->layers,
                       "Write the layers of a portal's layered depth image as FOLDER/layer-1.png, "
                       "the nearest, and so on, and print the samples in each")
          ->type_name("FOLDER")
          ->check(notEmpty());
  command
      ->add_option("--portal", options->portal,
                   "Whose layers to write; without it the portal with the most samples")
      ->type_name("ID")
      ->check(limits(0, 1e6))
      ->needs(layers);
  command
      ->add_option("--side", options->side,
                   "Seen from its front or its back; without it the side with more samples")
      ->type_name("front|back")
      ->check(CLI::IsMember({"front", "back"}).description(""))
      ->needs(layers);
  command->callback([options, &context] {
    context.run = [options, &context] { runInspect(*options, context.quiet); };
  });
}

}  // namespace enfilade
