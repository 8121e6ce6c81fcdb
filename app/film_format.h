#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace enfilade {

/// A kind of film file.
struct FilmFormat {
  const char* extension;  ///< by which it is chosen
  const char* muxer;      ///< ffmpeg's name of it
  std::vector<std::string> encoding;
};

/// The format of `file` by its extension.  Throws Error (kUsage) that says which there are.
const FilmFormat& filmFormatOf(const std::string& file);

/// ffmpeg's arguments for a film of RGBA frames of even `size` from its standard input.
std::vector<std::string> ffmpegArguments(const FilmFormat& format, const glm::ivec2& size,
                                         int frames_per_second, const std::string& output);

}  // namespace enfilade
