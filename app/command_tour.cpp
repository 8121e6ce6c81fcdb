#include <fmt/format.h>

#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/help_format.h"
#include "app/output_guard.h"
#include "preprocess/tour.h"

namespace enfilade {

namespace {

struct TourOptions {
  std::string house;
  std::string output;
  std::string format;
  TourParameters parameters;
};

PathFormat formatOf(const TourOptions& options) {
  if (options.format.empty()) return pathFormatOf(options.output);
  return options.format == "tum"    ? PathFormat::kTum
         : options.format == "gltf" ? PathFormat::kGltf
                                    : PathFormat::kTour;
}

void runTour(const TourOptions& options, bool quiet) {
  refuseToReplace(options.output, options.house);
  const House house = readHouse(options.house);
  const Tour tour = makeTour(house, options.parameters);
  writePath(options.output, tour.path, formatOf(options));
  for (const std::string& note : tour.notes) printNote(quiet, note);
  printNote(quiet,
            fmt::format("{}: {} frames through {} of {} cells", options.output,
                        tour.path.poses.size(), tour.visited.size(), house.graph.cells.size()));
}

void addWalkerOptions(CLI::App& command, TourParameters& parameters) {
  const auto add = [&](const char* name, float& value, const char* text) {
    command.add_option(name, value, text)
        ->type_name("M")
        ->capture_default_str()
        ->check(limits(0.01, 10))
        ->group("Walker");
  };
  add("--body-radius", parameters.body_radius, "Room kept free around the walker [m]");
  add("--step-height", parameters.step_height, "The highest step that the walker climbs [m]");
  add("--head-room", parameters.head_room, "The lowest passage that the walker enters [m]");
}

}  // namespace

void addTourCommand(CLI::App& program, CommandContext& context) {
  auto options = std::make_shared<TourOptions>();
  CLI::App* command =
      addCommand(program, "tour", "Plan a walk through every room that can be reached on foot",
                 "enfilade tour house -o tour.json --frames 520", context.quiet);
  command->add_option("HOUSE", options->house, "A folder that 'enfilade preprocess' made")
      ->required();
  command->add_option("-o,--output", options->output, "The path file to write")
      ->required()
      ->type_name("FILE");
  command->add_option("--frames", options->parameters.frames, "How many frames, 2 to 1000000")
      ->type_name("N")
      ->capture_default_str()
      ->check(limits(2, 1'000'000));
  command
      ->add_option("--format", options->format,
                   "json, tum (lines of: timestamp tx ty tz qx qy qz qw), or gltf (an animated "
                   "camera); unless told otherwise by FILE: .tum, .txt, .gltf, .glb, or else json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"json", "tum", "gltf"}).description(""));
  addWalkerOptions(*command, options->parameters);
  command->callback([options, &context] {
    context.run = [options, &context] { runTour(*options, context.quiet); };
  });
}

}  // namespace enfilade
