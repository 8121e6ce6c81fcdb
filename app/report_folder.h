#pragma once

#include "app/staged_folder.h"

namespace enfilade {

/// By what the folder of a report is known, and what play writes there.
FolderKind reportFolder();

}  // namespace enfilade
