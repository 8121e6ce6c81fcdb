#pragma once

#include <glm/glm.hpp>
#include <string>

namespace enfilade {

/// "640x512" as columns and rows.  Throws Error (kUsage) that names --size.
glm::ivec2 parseFrameSize(const std::string& text);

}  // namespace enfilade
