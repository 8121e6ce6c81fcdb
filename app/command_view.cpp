#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <filesystem>
#include <glm/gtc/constants.hpp>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/console.h"
#include "app/frame_size.h"
#include "app/help_format.h"
#include "app/interruption.h"
#include "app/memory_option.h"
#include "app/program.h"
#include "app/user_settings.h"
#include "app/view/actions.h"
#include "app/view/loading.h"
#include "render/lost_display.h"
#include "scene/error.h"

namespace enfilade {

namespace {

struct ViewArguments {
  std::string house, tour, size, method;
  std::string keep_in = ".";
  std::string images = "baked";
  bool fullscreen = false;
  float fov_degrees = 0;
  float speed = 0;
  std::optional<double> memory_mib;  ///< none: no limit
  int threads = 0;
  WarpingNames warping;
};

/// The house that is named, or the one that was viewed last; whole, so that it is found again from
/// anywhere.
std::string houseOf(const ViewArguments& arguments, const ViewSettings& remembered) {
  if (!arguments.house.empty()) {
    const auto path = std::filesystem::absolute(arguments.house).lexically_normal();
    return (path.has_filename() ? path : path.parent_path()).string();
  }
  if (!remembered.house.empty()) return remembered.house;
  throw Error(ErrorKind::kUsage, "",
              "no house named, and none was viewed before; see 'enfilade view --help'");
}

ViewOptions optionsOf(const ViewArguments& arguments, const CommandContext& context) {
  ViewOptions options;
  const ReadViewSettings remembered = readViewSettings(viewSettingsFile());
  if (!remembered.note.empty()) printNote(context.quiet, remembered.note);
  options.settings = remembered.settings;
  ViewSettings& settings = options.settings;
  options.house = houseOf(arguments, settings);
  if (!arguments.size.empty()) {
    const glm::ivec2 size = parseFrameSize(arguments.size);
    settings.width = size.x;
    settings.height = size.y;
    settings.fullscreen = false;
  }
  if (arguments.fullscreen) settings.fullscreen = true;
  if (!arguments.method.empty()) {
    const std::vector<Method> methods = parseMethods(arguments.method);
    if (methods.size() != 1) {
      throw Error(ErrorKind::kUsage, "--method " + arguments.method,
                  "takes one method; X in the window splits it for two");
    }
    settings.method = infoOf(methods.front()).name;
  }
  if (arguments.fov_degrees > 0) settings.fov_degrees = arguments.fov_degrees;
  if (arguments.speed > 0) settings.speed = arguments.speed;
  options.tour = arguments.tour;
  options.keep_in = arguments.keep_in;
  std::error_code ignored;
  if (!std::filesystem::is_directory(options.keep_in, ignored)) {
    throw Error(ErrorKind::kUsage, "--keep-in " + options.keep_in, "is no folder");
  }
  options.source = parseImageSource(arguments.images);
  options.most_bytes = memoryLimit(arguments.memory_mib, options.source);
  options.warping = parseWarping(arguments.warping);
  options.threads = arguments.threads;
  return options;
}

void sayDisplayIsGone() { printError("window: the display is gone"); }

/// A walk that is being recorded when the window closes is kept.
void sayWhatWasRecorded(Viewer& viewer) {
  if (const auto kept = viewer.keepRecording()) printNote(false, *kept);
}

void runView(const ViewArguments& arguments, const CommandContext& context) {
  const ViewOptions options = optionsOf(arguments, context);
  if (!isHouse(options.house))
    readHouse(options.house);  // says what is wrong before a window opens
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(options.threads));
  }
  const ViewSettings& settings = options.settings;
  GlfwWindow window({.title = "Enfilade",
                     .size = {settings.width, settings.height},
                     .full_screen = settings.fullscreen,
                     .threads = options.threads});
  const LastWords last_words(sayDisplayIsGone);
  const std::unique_ptr<WalkableHouse> walkable = loadBehindWindow(window, options);
  if (!walkable) return;
  Viewer viewer(window, *walkable, options);
  window.setTitle("Enfilade: " + std::filesystem::path(options.house).filename().string());
  const Interruption interruption;
  const LastWords of_viewer([&] {
    sayDisplayIsGone();
    sayWhatWasRecorded(viewer);
  });
  viewer.run();
  sayWhatWasRecorded(viewer);
  const std::string note = writeViewSettings(viewSettingsFile(), viewer.settings());
  if (!note.empty()) printNote(context.quiet, note);
  Interruption::throwIfAsked();
}

std::string keysHelp() {
  std::string text = "\n\nKeys:";
  for (const Binding& binding : bindings()) {
    // A column by characters, not bytes: some are arrows.
    std::string keys = binding.keys;
    std::size_t wide = 0;
    for (const char c : keys) wide += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    keys.append(wide < 12 ? 12 - wide : 1, ' ');
    text += fmt::format("\n  {}{}", keys, binding.what);
  }
  return text;
}

void addViewOptions(CLI::App& command, ViewArguments& arguments) {
  command.add_option("--method", arguments.method, "Method to begin with: " + methodNames())
      ->type_name("NAME");
  command
      .add_option(
          "--tour", arguments.tour,
          "A path to begin on, and to play by T: our JSON, TUM, or a glTF whose camera moves")
      ->type_name("FILE");
  command.add_option("--size", arguments.size, "Size of the window [pixels]")->type_name("WxH");
  command.add_flag("--fullscreen", arguments.fullscreen, "Fill the screen");
  command.add_option("--fov", arguments.fov_degrees, "Vertical field of view [degrees], 20 to 120")
      ->type_name("DEGREES")
      ->check(limits(20, 120));
  command.add_option("--speed", arguments.speed, "How fast one walks [m/s], 0.1 to 20")
      ->type_name("SPEED")
      ->check(limits(0.1, 20));
  command.add_option("--keep-in", arguments.keep_in, "Folder for pictures and paths that are kept")
      ->type_name("FOLDER")
      ->capture_default_str();
  command
      .add_option("--images", arguments.images,
                  "Where the portals' images come from: baked (files of the house), or on-demand "
                  "(made while walking)")
      ->type_name("SOURCE")
      ->capture_default_str();
  addMemoryOption(command, arguments.memory_mib);
  command.add_option("--threads", arguments.threads, "Threads; 0 is as many as the machine has")
      ->type_name("N")
      ->capture_default_str()
      ->check(limits(0, 1024));
  addWarpingOptions(command, arguments.warping);
}

}  // namespace

void addViewCommand(CLI::App& program, CommandContext& context) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command = addCommand(program, "view", "Walk through a house in a window",
                                 "enfilade view house --method ldi", context.quiet);
  command->footer(command->get_footer() +
                  "\n\nHouse, size, method, field of view and speed are remembered from one time "
                  "to the next." +
                  keysHelp());
  command->add_option("HOUSE", arguments->house,
                      "A folder that 'enfilade preprocess' made; without it the one viewed last");
  addViewOptions(*command, *arguments);
  command->callback([arguments, &context] {
    context.run = [arguments, &context] { runView(*arguments, context); };
  });
}

}  // namespace enfilade
