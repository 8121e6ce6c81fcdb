#include "app/film_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "scene/error.h"

namespace enfilade {

namespace {

/// Of a quality at which rendered edges and textures look as they do in the frames.
const std::vector<std::string> kH264 = {"-c:v", "libx264", "-preset", "fast", "-crf", "18"};

const std::vector<FilmFormat>& filmFormats() {
  static const std::vector<FilmFormat> formats = [] {
    std::vector<FilmFormat> all = {{"mp4", "mp4", kH264}, {"mkv", "matroska", kH264}};
    all[0].encoding.insert(all[0].encoding.end(), {"-movflags", "+faststart"});
    all.push_back({"webm",
                   "webm",
                   {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good",
                    "-cpu-used", "4", "-row-mt", "1"}});
    return all;
  }();
  return formats;
}

}  // namespace

const FilmFormat& filmFormatOf(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string known;
  for (const FilmFormat& format : filmFormats()) {
    if (extension == std::string(".") + format.extension) return format;
    known += (known.empty() ? "." : ", .") + std::string(format.extension);
  }
  throw Error(ErrorKind::kUsage, "--video " + file,
              "no film's name; the extension says the format: " + known);
}

std::vector<std::string> ffmpegArguments(const FilmFormat& format, const glm::ivec2& size,
                                         int frames_per_second, const std::string& output) {
  std::vector<std::string> arguments = {"-hide_banner", "-loglevel", "error",
                                        "-nostdin",     "-y",        "-xerror"};
  const auto add = [&](std::initializer_list<std::string> more) {
    arguments.insert(arguments.end(), more);
  };
  add({"-f", "rawvideo", "-pix_fmt", "rgb0", "-video_size", fmt::format("{}x{}", size.x, size.y)});
  add({"-framerate", std::to_string(frames_per_second), "-i", "pipe:0"});
  // Said outright, since players guess the colours' meaning from the size otherwise.
  add({"-vf",
       "scale=flags=accurate_rnd+full_chroma_int:out_color_matrix=bt709:out_range=tv,"
       "format=yuv420p"});
  add({"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"});
  add({"-color_range", "tv", "-g", std::to_string(2 * frames_per_second)});
  arguments.insert(arguments.end(), format.encoding.begin(), format.encoding.end());
  add({"-f", format.muxer, "file:" + output});  // file: so that no name is taken for an address
  return arguments;
}

}  // namespace enfilade
