#include "app/play_options.h"

#include "app/gl_option.h"
#include "app/help_format.h"
#include "app/memory_option.h"

namespace enfilade {

namespace {

void addWalkOptions(CLI::App& command, PlayOptions& options) {
  command
      .add_option("--methods", options.methods,
                  "Methods to play, joined by commas: " + methodNames())
      ->type_name("LIST")
      ->capture_default_str();
  command
      .add_option("--tour", options.tour,
                  "The path: our JSON, TUM, or a glTF whose camera moves; without it the house's "
                  "own tour")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      .add_option("--shut", options.shut,
                  "Doors to shut: their portals' numbers, names, "
                  "or patterns with * and ?, joined by commas; a tour may move them on the way")
      ->type_name("PORTALS");
  command.add_option("--open", options.open, "Doors to open that the house has shut")
      ->type_name("PORTALS");
  command
      .add_option("--images", options.images,
                  "Where the portals' images come from: baked (files of the house), or on-demand "
                  "(made while walking, at most one capture a frame; until its image is there a "
                  "portal shows geometry; at most 256 MiB of images are kept a method)")
      ->type_name("SOURCE")
      ->capture_default_str();
  addMemoryOption(command, options.memory_mib);
  command.add_option("--size", options.size, "Size of a frame [pixels]")
      ->type_name("WxH")
      ->capture_default_str();
  command
      .add_option("--fov", options.fov_degrees,
                  "Vertical field of view [degrees], 1 to 170; without it the path's own")
      ->type_name("DEGREES")
      ->check(limits(1, 170));
  command.add_option("--threads", options.threads, "Threads; 0 is as many as the machine has")
      ->type_name("N")
      ->capture_default_str()
      ->check(limits(0, 1024));
  addGlOption(command, options.gl);
  command
      .add_option("--warm-up", options.playback.warm_up,
                  "Frames painted before the first that counts, for each method")
      ->type_name("N")
      ->capture_default_str()
      ->check(limits(0, 10'000));
  addWarpingOptions(command, options.warping);
}

void addPictureOptions(CLI::App& command, PlayOptions& options) {
  command
      .add_flag("--quality", options.playback.quality,
                "Compare every frame with geometry, untimed: PSNR and SSIM of the frame and inside "
                "the portals' images, pixels that differ, flicker, the jump at switches; and keep "
                "the worst frames in REPORT/contact-sheet.png")
      ->group("Pictures");
  command
      .add_option("--pictures", options.pictures,
                  "Small pictures kept a method, evenly spaced, for report.html to show: at most N "
                  "frames as REPORT/pictures/METHOD/00012.jpg, painted untimed; 0: none")
      ->type_name("N")
      ->capture_default_str()
      ->check(limits(0, 100'000))
      ->group("Pictures");
  command
      .add_option("--frames-dir", options.playback.frames_dir,
                  "Keep every frame as FOLDER/METHOD/frame-00000.png")
      ->type_name("FOLDER")
      ->check(notEmpty())
      ->group("Pictures");
}

}  // namespace

void addPlayOptions(CLI::App& command, PlayOptions& options) {
  command.add_option("HOUSE", options.house, "A folder that 'enfilade preprocess' made")
      ->required();
  command
      .add_option(
          "-o,--output", options.output,
          "The report folder to write: report.html, summary.json, frames.csv, pictures, and "
          "with --quality contact-sheet.png; required unless --video or --frames-dir is given")
      ->type_name("REPORT")
      ->check(notEmpty());
  addWalkOptions(command, options);
  addPictureOptions(command, options);
  addFilmOptions(command, options.film);
}

}  // namespace enfilade
