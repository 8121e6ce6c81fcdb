#include <fmt/format.h>

#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/gl_option.h"
#include "app/help_format.h"
#include "app/preprocess_run.h"
#include "ibr/capture_plan.h"
#include "preprocess/preprocess.h"
#include "scene/error.h"

namespace enfilade {

namespace {

struct PreprocessOptions {
  std::string model;
  std::string output;
  bool no_images = false;
  std::string bake;
  PreprocessParameters parameters;
  std::string captures = capturePlanText(parameters.image.rings);
};

void runPreprocess(const PreprocessOptions& options, bool quiet) {
  PreprocessParameters parameters = options.parameters;
  parameters.images = !options.no_images;
  parameters.image.rings = parseCapturePlan(options.captures);
  parameters.image.bake = parseImageKinds(options.bake);
  // Before the long work, so that a machine without it says so at once.
  if (parameters.images && parameters.gl == GlBackend::kEgl) createGlContext(parameters.gl, 1);
  const PreprocessResult result =
      runPreprocessing(options.model, options.output, parameters, quiet);
  double seconds = 0;
  for (const StageTime& stage : result.stages) seconds += stage.seconds;
  const CellGraph& graph = result.house.graph;
  const HouseInfo& info = result.house.info;
  const bool said = info.parameters.at("cells") != "automatic";  // by someone who wants an answer
  for (const std::string& line : info.log) {
    const bool hint = line.find("; --") != std::string::npos;  // what an option would have found
    if ((said && !hint) || line.starts_with("LEAK")) printNote(quiet, "note: " + line);
  }
  printResult(
      fmt::format("{}: {} cells, {} portals, {} storeys, {} triangles, {} portal sides with images "
                  "({:.1f} MB), "
                  "{:.1f} s\n",
                  options.output, graph.cells.size(), graph.portals.size(), graph.storeys.size(),
                  triangleCount(result.house.building), result.images,
                  static_cast<double>(result.image_bytes) / 1e6, seconds));
}

/// Throws Error (kUsage).
LdiMaking ldiMaking(const std::string& name) {
  if (name == "warp") return LdiMaking::kWarp;
  if (name == "raycast") return LdiMaking::kRayCast;
  throw Error(ErrorKind::kUsage, "--ldi " + name, "no such way; there are: warp, raycast");
}

/// One option of `group`; the default and the limits show in its help.
template <typename T>
void addNumber(CLI::App& command, const char* group, const char* name, T& value, const char* text,
               const char* unit, double least, double most) {
  command.add_option(name, value, fmt::format("{}, {} to {}", text, least, most))
      ->type_name(unit)
      ->capture_default_str()
      ->check(limits(least, most))
      ->group(group);
}

void addCellOptions(CLI::App& command, PreprocessParameters& parameters) {
  constexpr const char* kGroup = "Cells and portals";
  command
      .add_option("--doors", parameters.doors,
                  "Names of openable doors: no obstacle, not drawn while walking; wildcards * and "
                  "?, several joined by commas, '' for none; unless told otherwise IfcDoor* and "
                  "Door or door with a number")
      ->type_name("NAMES")
      ->group(kGroup);
  command
      .add_option(
          "--windows", parameters.windows,
          "Names of windows that can be seen through; see-through material always can; unless "
          "told otherwise IfcWindow* and Window or window with a number")
      ->type_name("NAMES")
      ->group(kGroup);
  CLI::Option* automatic = command.add_flag(
      "--auto", parameters.automatic,
      "Find all cells and portals, whatever the model names (NAME-room, NAME-portal)");
  automatic->group(kGroup);
  CLI::Option* named_only =
      command.add_flag("--named-only", parameters.named_only,
                       "Take the cells and portals that the model names and find no others");
  named_only->excludes(automatic)->group(kGroup);
  command
      .add_option("--graph", parameters.graph,
                  "Take the cells and portals of a house.json, edited or not, as given; and its "
                  "--doors and --windows where they are not named here")
      ->type_name("house.json")
      ->check(notEmpty())
      ->excludes(automatic)
      ->excludes(named_only)
      ->group(kGroup);
  CellParameters& cells = parameters.cells;
  addNumber(command, kGroup, "--voxel", cells.voxel, "Edge of a voxel [m]", "M", 0.02, 1.0);
  addNumber(command, kGroup, "--slice-height", cells.slice_height,
            "Height above a floor where rooms are told apart [m]", "M", 0.1, 5.0);
  addNumber(command, kGroup, "--merge-ratio", cells.merge_ratio,
            "Spaces joined by a neck wider than this share of the smaller one are one room",
            "RATIO", 0.0, 1.0);
  addNumber(command, kGroup, "--smallest-room", cells.smallest_room,
            "Smaller spaces are merged [m2]", "M2", 0.0, 100.0);
  addNumber(command, kGroup, "--smallest-door", cells.smallest_door,
            "Narrower passages are cracks, not doors [m]", "M", 0.05, 5.0);
  addNumber(command, kGroup, "--sight-lines", parameters.rays_per_cell,
            "Sight lines sampled from each cell to see what its portals show", "N", 0, 100'000'000);
}

void addImageOptions(CLI::App& command, PreprocessOptions& options) {
  constexpr const char* kGroup = "Images at the portals";
  command.add_flag("--no-images", options.no_images, "Bake no images: for culling alone")
      ->group(kGroup);
  options.bake = imageKindNames(options.parameters.image.bake);
  command
      .add_option("--bake", options.bake,
                  "Which images, joined by commas: texture (portal textures), warp (reference "
                  "images, for warp and warp2), ldi (layered depth images)")
      ->type_name("KINDS")
      ->capture_default_str()
      ->group(kGroup);
  addGlOption(command, options.parameters.gl)->group(kGroup);
  ImageParameters& image = options.parameters.image;
  addNumber(command, kGroup, "--image-size", image.image_size,
            "Rows of an image of a portal 2.1 m high, others in proportion [pixels]", "PIXELS", 16,
            4096);
  command
      .add_option("--captures", options.captures,
                  "Viewpoints before a portal: rings of ring:COUNT, joined by commas, each perhaps "
                  "with @HEIGHT above the eye [m] and /ANGLE of the outermost [degrees]; the "
                  "paper's is ring:13")
      ->type_name("PLAN")
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_option_function<std::string>(
          "--ldi",
          [&image](const std::string& name) { image.ldi = ldiMaking(CLI::detail::to_lower(name)); },
          "How a layered depth image is made: warp captures into one, or raycast, which "
          "keeps what rays of the central view meet and some viewpoint sees")
      ->type_name("HOW")
      ->default_str("warp")
      ->group(kGroup);
  addNumber(command, kGroup, "--textures-per-portal", image.textures,
            "Portal textures a side, evenly along the semicircle", "N", 1, 180);
  addNumber(command, kGroup, "--images-per-portal", image.references,
            "Reference images a side, evenly along the semicircle", "N", 1, 180);
  addNumber(command, kGroup, "--switch-distance", image.switch_distance,
            "Nearer to a portal than this the geometry is drawn [m]", "M", 0.05, 100.0);
  addNumber(command, kGroup, "--eye-height", options.parameters.eye_height,
            "Height of the eye above the floor [m]", "M", 0.2, 3.0);
}

}  // namespace

void addPreprocessCommand(CLI::App& program, CommandContext& context) {
  auto options = std::make_shared<PreprocessOptions>();
  CLI::App* command = addCommand(
      program, "preprocess",
      "Divide a building into cells and portals and bake the portals' images",
      "enfilade preprocess duplex.glb -o duplex --doors 'IfcDoor*' --windows 'IfcWindow*'",
      context.quiet);
  command->add_option("MODEL", options->model, "The building: a .glb, .gltf or .obj file")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "The house folder to write; what an interrupted run of the same command left "
                   "there is gone on with")
      ->required()
      ->type_name("HOUSE");
  command
      ->add_flag("--bake-light", options->parameters.bake_light,
                 "Light the building first, as the sky through its windows and doors and its own "
                 "lamps (KHR_lights_punctual) would, with diffuse reflections")
      ->group("Light");
  addCellOptions(*command, options->parameters);
  addImageOptions(*command, *options);
  addNumber(*command, "General", "-j,--jobs", options->parameters.threads,
            "Threads; 0 is as many as the machine has", "N", 0, 1024);
  command->callback([options, &context] {
    context.run = [options, &context] { runPreprocess(*options, context.quiet); };
  });
}

}  // namespace enfilade
