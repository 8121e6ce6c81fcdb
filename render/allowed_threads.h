#pragma once

#include <tbb/global_control.h>

namespace enfilade {

/// How many threads oneTBB may use: what `--threads` says, or as many as the machine has.
/// (tbb::this_task_arena::max_concurrency() does not keep to what `--threads` says.)
inline int allowedThreads() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace enfilade
