#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <filesystem>
#include <glm/gtc/constants.hpp>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/console.h"
#include "app/film.h"
#include "app/film_path.h"
#include "app/frame_size.h"
#include "app/help_format.h"
#include "app/interruption.h"
#include "app/memory_option.h"
#include "app/output_guard.h"
#include "app/path_within.h"
#include "app/play_images.h"
#include "app/play_options.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/report_facts.h"
#include "app/report_folder.h"
#include "app/staged_folder.h"
#include "app/walk.h"
#include "app/warping.h"
#include "portals/open_doors.h"
#include "preprocess/tour.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace {

CameraPath pathFor(const PlayOptions& options, const House& house, bool quiet) {
  if (options.tour.empty()) {
    Tour tour = makeTour(house, {});
    for (const std::string& note : tour.notes) printNote(quiet, note);
    return tour.path;
  }
  CameraPath path = readCameraPath(options.tour);
  if (path.poses.empty()) throw Error(ErrorKind::kBadInput, options.tour, "holds no poses");
  return path;
}

/// Moves the doors that the command line names.
void moveAskedDoors(const PlayOptions& options, House& house) {
  if (options.shut.empty() && options.open.empty()) return;
  const std::vector<std::uint8_t> closable = closablePortals(house);
  const auto move = [&](const std::string& names, bool open, const char* option) {
    if (!names.empty()) {
      moveDoors(names, open, closable, ErrorKind::kUsage, option, house.graph);
    }
  };
  move(options.open, true, "--open");
  move(options.shut, false, "--shut");
}

/// `folder` as seen from the report, for the page's pictures.
std::string relativeTo(const std::string& report, const std::string& folder) {
  if (folder.empty() || report.empty()) return {};
  return pathWithin(report, folder).string();
}

/// What was chosen besides the methods, the size, the threads and the field of view.
std::vector<std::pair<std::string, std::string>> parametersOf(const PlayOptions& options) {
  return {{"images", options.images},
          {"splat", options.warping.splat},
          {"holes", options.warping.holes},
          {"clip", options.warping.clip},
          {"gl", glBackendName(options.gl)},
          {"memory", options.memory_mib ? fmt::format("{} MiB", *options.memory_mib) : "no limit"},
          {"warm-up", std::to_string(options.playback.warm_up)},
          {"shut", options.shut},
          {"open", options.open}};
}

Report describe(const PlayOptions& options, const House& house, const PlayImages& images,
                const CameraPath& path) {
  Report report;
  report.tool_version = ENFILADE_VERSION;
  report.house = options.house;
  describeHouse(house, report);
  describePath(house, path, report);
  report.tour = options.tour.empty() ? "the house's own" : options.tour;
  report.images = images.count();
  report.threads = options.threads;
  report.parameters = parametersOf(options);
  report.methods = options.playback.methods;
  report.frames_dir = relativeTo(options.output, options.playback.frames_dir);
  return report;
}

void writeReport(const Report& report, StagedFolder& folder) {
  writeFileAtomically(folder.path() + "/frames.csv", framesCsv(report));
  writeFileAtomically(folder.path() + "/summary.json", summaryJson(report));
  writeFileAtomically(folder.path() + "/report.html", reportHtml(report));
  if (report.findings.sheet) {
    writePng(folder.path() + "/" + kContactSheetFile, report.findings.sheet->picture);
  }
  folder.commit();
}

void requireSomeOutput(const PlayOptions& options) {
  if (!options.output.empty() || !options.film.file.empty()) return;
  if (!options.playback.frames_dir.empty()) return;
  throw Error(ErrorKind::kUsage, "",
              "--output is required, unless --video or --frames-dir says what to make; see "
              "'enfilade play --help'");
}

/// Where to write what is to stand at `path` in the end: what lies within the report's folder is
/// staged with it, since that folder takes the place of the one before.
std::string stagedPath(const std::string& path, const PlayOptions& options,
                       const std::optional<StagedFolder>& report) {
  const std::string within = relativeTo(options.output, path);
  return within.empty() || within.starts_with("..") ? path : report->path() + "/" + within;
}

/// The film that is asked for, if one is.
std::optional<Film> filmFor(const PlayOptions& options, const std::optional<StagedFolder>& report,
                            const glm::ivec2& size) {
  if (options.film.file.empty()) return std::nullopt;
  const std::string output = stagedPath(options.film.file, options, report);
  if (output != options.film.file) {
    createFolders(std::filesystem::path(output).parent_path().string());
  }
  return std::optional<Film>(std::in_place, options.film, output, options.playback.methods, size);
}

/// What is asked to stop stops at the next frame.
ProgressSink stoppable(ProgressSink sink) {
  return [sink = std::move(sink)](const std::string& stage, double done) {
    Interruption::throwIfAsked();
    sink(stage, done);
  };
}

void playAndFilm(FramePainter& painter, const Walk& walk, const Walk& film_walk,
                 const PlaybackParameters& parameters, std::optional<Film>& film, bool quiet,
                 Report& report) {
  ProgressPrinter progress(quiet);
  const ProgressSink sink = stoppable(progress.sink());
  Playback played = playBack(painter, walk, parameters, sink);
  report.records = std::move(played.records);
  report.findings = std::move(played.findings);
  if (film) film->shoot(painter, film_walk, report.records, sink);
}

/// Has pictures of the walk kept for the report that is made in `report`.
void keepPictures(const std::string& report, std::size_t frames, const Warping& warping,
                  PlayOptions& options) {
  options.playback.keeper = PictureKeeper(report + "/" + kPicturesFolder, frames,
                                          static_cast<std::size_t>(options.pictures));
  options.playback.in_order = parseImageSource(options.images) == ImageSource::kOnDemand ||
                              warping.holes == Holes::kPersist;
}

/// Plays, with the report's folder if one is asked for.
void playInto(std::optional<StagedFolder>& folder, PlayOptions options,
              const CommandContext& context) {
  const glm::ivec2 size = parseFrameSize(options.size);
  const ImageSource source = parseImageSource(options.images);
  const std::optional<std::size_t> most_bytes = memoryLimit(options.memory_mib, source);
  const Warping warping = parseWarping(options.warping);
  std::optional<Film> film = filmFor(options, folder, size);
  House house = readHouse(options.house);
  moveAskedDoors(options, house);
  const CameraPath path = pathFor(options, house, context.quiet);
  PlayImages images;
  if (source == ImageSource::kBaked) {
    images = PlayImages(house, options.house, options.playback.methods, most_bytes);
  }
  if (!images.note().empty()) printNote(context.quiet, images.note());

  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(options.threads));
  }
  const std::unique_ptr<GlContext> gl = createGlContext(options.gl, options.threads);
  FramePainter painter(*gl, house, images.images(), size.x, size.y, options.threads, source);
  painter.setLimited(images.limited());
  painter.setWarping(warping);
  const float fov = options.fov_degrees > 0 ? glm::radians(options.fov_degrees) : path.vertical_fov;
  const Camera camera = walkingCamera(house, fov, size.x, size.y);
  const Walk walk(path, camera, house, options.tour);
  const CameraPath film_path =
      film ? filmPath(path, options.film.frames_per_second, options.tour) : path;
  const Walk film_walk(film_path, camera, house, options.tour);

  Report report = describe(options, house, images, path);
  report.command = context.command_line;
  report.width = size.x;
  report.height = size.y;
  report.vertical_fov_degrees = static_cast<double>(glm::degrees(fov));
  report.machine = describeMachine(gl->description());
  if (report.threads == 0) report.threads = report.machine.cores;
  if (folder) keepPictures(folder->path(), walk.frames(), warping, options);
  report.picture_stride = options.playback.keeper.stride();
  options.playback.frames_dir = stagedPath(options.playback.frames_dir, options, folder);
  playAndFilm(painter, walk, film_walk, options.playback, film, context.quiet, report);
  if (folder) writeReport(report, *folder);
  printResult(reportTable(report) + (film ? film->description() : "") +
              (folder ? "report: " + options.output + "/report.html\n" : ""));
}

void runPlay(PlayOptions options, const CommandContext& context) {
  options.playback.methods = parseMethods(options.methods);
  requireSomeOutput(options);
  for (const std::string& output :
       {options.output, options.film.file, options.playback.frames_dir}) {
    refuseToReplace(output, options.house);
  }
  const Interruption interruption;
  std::optional<StagedFolder> folder;
  if (!options.output.empty()) folder.emplace(options.output, reportFolder());
  try {
    playInto(folder, options, context);
  } catch (const Error& error) {
    if (!folder) throw;
    throw Error(error.kind(), "", folder->asCommitted(error.what()));
  }
}

std::string methodsHelp() {
  std::string text = "\n\nMethods:";
  for (const MethodInfo& info : allMethods()) {
    text += fmt::format("\n  {:<9} {}", info.name, info.description);
  }
  return text;
}

}  // namespace

void addPlayCommand(CLI::App& program, CommandContext& context) {
  auto options = std::make_shared<PlayOptions>();
  CLI::App* command =
      addCommand(program, "play", "Play a walk by several methods and report what each frame took",
                 "enfilade play house --methods geometry,raycast,culling,ldi --quality -o report",
                 context.quiet);
  command->footer(command->get_footer() + methodsHelp());
  addPlayOptions(*command, *options);
  command->callback(
      [options, &context] { context.run = [options, &context] { runPlay(*options, context); }; });
}

}  // namespace enfilade
