#pragma once

#include <cstddef>
#include <string>

#include "app/methods.h"

namespace enfilade {

/// Where a kept frame lies under its folder: "ldi/frame-00012.png".
std::string frameFile(Method method, std::size_t frame);

}  // namespace enfilade
