#include "app/film_options.h"

#include "app/help_format.h"

namespace enfilade {

void addFilmOptions(CLI::App& command, FilmParameters& film) {
  constexpr const char* kGroup = "Film";
  command
      .add_option("--video", film.file,
                  "Make a film of the walk by ffmpeg (apt-get install ffmpeg): .mp4, .mkv or "
                  ".webm; several methods stand side by side, more than three in two rows")
      ->type_name("FILE")
      ->check(notEmpty())
      ->group(kGroup);
  command
      .add_option("--fps", film.frames_per_second,
                  "The film's frames a second; it lasts as long as the path, whatever they are")
      ->type_name("N")
      ->capture_default_str()
      ->check(limits(1, 240))
      ->group(kGroup);
  command
      .add_flag_function(
          "--captions,!--no-captions", [&film](std::int64_t count) { film.captions = count > 0; },
          "Write each method's name and frame times into the film; unless told, where it shows "
          "several methods")
      ->group(kGroup);
}

}  // namespace enfilade
