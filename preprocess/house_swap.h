#pragma once

#include <string>

namespace enfilade {

/// Puts the finished house in the folder `from` in the place of the one in `folder`, part by part
/// by renaming: `from`/finished.json becomes house.json, last of all.  What is there is first moved
/// to `from`/replaced; if any of it cannot be, all is moved back.  It goes on with what was stopped
/// at any moment.  Throws Error (kMachine).
void swapHouse(const std::string& folder, const std::string& from);

/// Moves what a stopped swapHouse() had moved away back, if nothing stands in its place yet.
void unswapHouse(const std::string& folder, const std::string& from);

/// `from`/replaced
std::string replacedFolder(const std::string& from);

}  // namespace enfilade
