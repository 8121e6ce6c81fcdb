#include "app/machine_info.h"

#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <thread>

namespace enfilade {

namespace {

/// What follows `key` and any blanks, ':' or '=' on the first line of `file` that starts with it.
std::string valueIn(const std::string& file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t start = line.find_first_not_of(" \t:=\"", key.size());
    if (start == std::string::npos) continue;
    return line.substr(start, line.find_last_not_of("\" \t") - start + 1);
  }
  return {};
}

int usableCores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
  return static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

std::uint64_t machineMemory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

MachineInfo describeMachine(const std::string& gl_renderer) {
  MachineInfo info;
  utsname kernel{};
  uname(&kernel);
  info.cpu = valueIn("/proc/cpuinfo", "model name");
  if (info.cpu.empty()) info.cpu = kernel.machine;
  info.cores = usableCores();
  info.memory_bytes = machineMemory();
  info.system = valueIn("/etc/os-release", "PRETTY_NAME");
  info.system +=
      (info.system.empty() ? "" : ", ") + std::string(kernel.sysname) + " " + kernel.release;
  info.gl_renderer = gl_renderer;
  return info;
}

}  // namespace enfilade
