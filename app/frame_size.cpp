#include "app/frame_size.h"

#include <charconv>

#include "scene/error.h"

namespace enfilade {

glm::ivec2 parseFrameSize(const std::string& text) {
  glm::ivec2 size(0);
  const char* const end = text.data() + text.size();
  const auto [after_width, bad_width] = std::from_chars(text.data(), end, size.x);
  const bool has_both = bad_width == std::errc() && after_width != end && *after_width == 'x';
  const char* const height = has_both ? after_width + 1 : end;
  const auto [after_height, bad_height] = std::from_chars(height, end, size.y);
  const bool found = bad_height == std::errc() && after_height == end;
  if (!found || size.x < 16 || size.y < 16 || size.x > 16384 || size.y > 16384) {
    throw Error(ErrorKind::kUsage, "--size " + text,
                "no size; write WIDTHxHEIGHT in pixels, each 16 to 16384, such as 640x512");
  }
  return size;
}

}  // namespace enfilade
