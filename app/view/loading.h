#pragma once

#include <functional>
#include <string>

#include "app/view/viewer.h"

namespace enfilade {

/// Reads what a walk needs: house, the images of the first method, where one can stand, the tour.
/// `tell`: what is being done, from the thread that calls.  Throws Error (kBadInput).
std::unique_ptr<WalkableHouse> loadWalkable(const ViewOptions& options,
                                            const std::function<void(const std::string&)>& tell);

/// The same in a thread of its own, while `window` says what is being done.  Null if the window was
/// closed meanwhile.
std::unique_ptr<WalkableHouse> loadBehindWindow(GlfwWindow& window, const ViewOptions& options);

}  // namespace enfilade
