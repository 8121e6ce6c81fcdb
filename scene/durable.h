#pragma once

#include <string>

namespace enfilade {

/// Returns when the files that lie in `folder`, not those in its folders, and all their names are
/// on the disk, so that not even a power cut takes them.  Throws Error (kMachine) with the system's
/// reason.
void syncFolder(const std::string& folder);

}  // namespace enfilade
