#pragma once

#include <string>

#include "preprocess/preprocess.h"

namespace enfilade {

/// preprocessBuilding() for a person who waits: with progress and notes, unless `quiet`, and
/// stopped by SIGINT, SIGTERM or SIGHUP within about a second, saying what is kept.  Throws
/// Interrupted then.
PreprocessResult runPreprocessing(const std::string& model, const std::string& output,
                                  const PreprocessParameters& parameters, bool quiet);

}  // namespace enfilade
