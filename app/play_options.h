#pragma once

#include <optional>
#include <string>

#include "app/film_options.h"
#include "app/playback.h"
#include "app/warping.h"
#include "render/gl_context.h"

namespace CLI {
class App;
}  // namespace CLI

namespace enfilade {

/// What the command line asks of a playback, as it is named there.
struct PlayOptions {
  std::string house, tour, output;
  std::string methods = "geometry,culling,ldi";
  std::string images = "baked";
  std::string size = "640x512";
  std::string shut, open;  ///< portals
  float fov_degrees = 0;   ///< 0: the path's own
  int threads = 0;
  std::optional<double> memory_mib;  ///< of the portals' images; none: all of them
  GlBackend gl = GlBackend::kOsMesa;
  int pictures = 130;  ///< kept for the report's page, a method
  WarpingNames warping;
  FilmParameters film;
  PlaybackParameters playback;
};

/// Adds the house, the report, and all options of `enfilade play`, which set `options`.
void addPlayOptions(CLI::App& command, PlayOptions& options);

}  // namespace enfilade
