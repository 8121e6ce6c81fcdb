#pragma once

#include <functional>
#include <string>

namespace enfilade {

/// Told of long work: the stage's name (the same string through a stage) and the share done, 0…1; 1
/// ends the stage. Called from one thread at a time.
using ProgressSink = std::function<void(const std::string& stage, double done)>;

}  // namespace enfilade
