#include <fmt/format.h>

#include <cstdint>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/help_format.h"
#include "models/samples.h"
#include "scene/gltf_writer.h"

namespace enfilade {

namespace {

struct SampleOptions {
  std::string name;
  std::string output;
  std::uint64_t triangles = 0;
};

void runSample(const SampleOptions& options, bool quiet) {
  const Building building = raiseSample(options.name, options.triangles);
  writeGlb(options.output, building);
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
      ->add_option("NAME", options->name,
                   fmt::format("Which building: {}", fmt::join(sampleNames(), ", ")))
      ->required();
  command->add_option("-o,--output", options->output, "The GLB file to write")
      ->required()
      ->type_name("FILE");
  command
      ->add_option(
          "--triangles", options->triangles,
          "About how many triangles, 50000 to 10000000; the sample's own number without it")
      ->type_name("N")
      ->check(limits(50e3, 10e6));
  command->callback([options, &context] {
    context.run = [options, &context] { runSample(*options, context.quiet); };
  });
}

}  // namespace enfilade
