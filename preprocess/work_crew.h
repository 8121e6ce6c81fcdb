#pragma once

#include <cstddef>
#include <functional>

namespace enfilade {

/// Does one job after another on one thread: told the job's number.
using Worker = std::function<void(std::size_t job)>;

/// Has jobs 0 … `jobs` − 1 done once each, by up to `threads` workers (0: as many as the machine
/// has), each on a thread of its own on which `hire` made it.  A worker takes the first job that no
/// other has, so the work must not depend on who does it or when.  Returns when all is done; an
/// exception ends the work, and the first one goes on from here.
void shareOutJobs(std::size_t jobs, int threads, const std::function<Worker()>& hire);

}  // namespace enfilade
