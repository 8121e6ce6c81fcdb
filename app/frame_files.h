#pragma once

#include <cstddef>
#include <string>

#include "app/methods.h"

namespace enfilade {

/// Where a kept frame lies under its folder: "ldi/frame-00012.png".
std::string frameFile(Method method, std::size_t frame);

/// Removes the frames of `method` from number `count` on that an earlier, longer walk left in
/// `folder`.  Throws Error (kMachine).
void removeFramesFrom(std::size_t count, const std::string& folder, Method method);

}  // namespace enfilade
