#include "app/frame_size.h"

#include <cstdio>

#include "scene/error.h"

namespace enfilade {

glm::ivec2 parseFrameSize(const std::string& text) {
  glm::ivec2 size(0);
  char after = 0;
  const int found = std::sscanf(text.c_str(), "%dx%d%c", &size.x, &size.y, &after);  // NOLINT
  if (found != 2 || size.x < 16 || size.y < 16 || size.x > 16384 || size.y > 16384) {
    throw Error(ErrorKind::kUsage, "--size " + text,
                "no size; write WIDTHxHEIGHT in pixels, each 16 to 16384, such as 640x512");
  }
  return size;
}

}  // namespace enfilade
