#pragma once

#include <cstdint>
#include <string>

namespace enfilade {

/// What a report says of the machine that it was made on.
struct MachineInfo {
  std::string cpu;  ///< the model's name, or the architecture
  int cores = 0;    ///< that this process may run on
  std::uint64_t memory_bytes = 0;
  std::string system;       ///< "Debian GNU/Linux 12 (bookworm), Linux 6.1.0"
  std::string gl_renderer;  ///< empty: no OpenGL was used
};

/// [bytes] of physical memory.
std::uint64_t machineMemory();

MachineInfo describeMachine(const std::string& gl_renderer);

}  // namespace enfilade
