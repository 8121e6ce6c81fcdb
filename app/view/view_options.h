#pragma once

#include <optional>
#include <string>

#include "app/frame_painter.h"
#include "app/user_settings.h"

namespace enfilade {

/// What the command line asks of the window.
struct ViewOptions {
  std::string house;      ///< its folder
  std::string tour;       ///< a path's file; empty: none
  std::string keep_in;    ///< folder for pictures and paths that are kept
  ViewSettings settings;  ///< remembered, and what the command line says instead
  ImageSource source = ImageSource::kBaked;
  std::optional<std::size_t> most_bytes = {};  ///< of baked images in memory; none: no limit
  Warping warping;
  int threads = 0;
  bool quiet = false;
};

}  // namespace enfilade
