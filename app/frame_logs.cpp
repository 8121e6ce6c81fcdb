#include "app/frame_logs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

/// Neither format has quotes: what would end a cell becomes a blank.
std::string asCell(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return c == ',' || c == '"' || static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

/// "Debian GNU/Linux 12 (bookworm), Linux 6.1.0" as its two parts.
std::pair<std::string, std::string> systemAndKernel(const std::string& system) {
  const std::size_t comma = system.rfind(", ");
  if (comma == std::string::npos) return {system, {}};
  return {system.substr(0, comma), system.substr(comma + 2)};
}

}  // namespace

std::string mangoHudLog(const RecordedRun& run, const RecordedMethod& method) {
  const auto [system, kernel] = systemAndKernel(run.machine.system);
  std::string log = "os,cpu,gpu,ram,kernel,driver,cpuscheduler\n";
  log += fmt::format("{},{},{},{},{},enfilade {},\n", asCell(system), asCell(run.machine.cpu),
                     asCell(run.machine.gl_renderer), run.machine.memory_bytes / 1024,
                     asCell(kernel), asCell(method.name));
  log +=
      "fps,frametime,cpu_load,cpu_power,gpu_load,cpu_temp,gpu_temp,gpu_core_clock,gpu_mem_clock,"
      "gpu_vram_used,gpu_power,ram_used,swap_used,process_rss,cpu_mhz,elapsed\n";
  double elapsed_ms = 0;
  for (const double ms : method.values("frametime_ms")) {
    elapsed_ms += ms;
    log += fmt::format("{:.4f},{:.4f},0,0,0,0,0,0,0,0,0,0,0,0,0,{:.0f}\n", 1000 / ms, ms,
                       elapsed_ms * 1e6);
  }
  return log;
}

std::string presentMonLog(const RecordedRun&, const RecordedMethod& method) {
  std::string log =
      "Application,ProcessID,SwapChainAddress,Runtime,SyncInterval,PresentFlags,Dropped,"
      "TimeInSeconds,msInPresentAPI,msBetweenPresents,AllowsTearing,PresentMode,"
      "msUntilRenderComplete,msUntilDisplayed,msBetweenDisplayChange\n";
  const std::string application = asCell("enfilade-" + method.name + ".exe");
  double elapsed_ms = 0;
  for (const double ms : method.values("frametime_ms")) {
    elapsed_ms += ms;
    log += fmt::format("{},0,0x0,Other,0,0,0,{:.7f},0,{:.4f},0,Other,{:.4f},{:.4f},{:.4f}\n",
                       application, elapsed_ms / 1000, ms, ms, ms, ms);
  }
  return log;
}

}  // namespace enfilade
