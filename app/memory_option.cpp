#include "app/memory_option.h"

#include <cmath>

#include "app/help_format.h"
#include "scene/error.h"

namespace enfilade {

void addMemoryOption(CLI::App& command, std::optional<double>& mib) {
  command
      .add_option(
          "--memory", mib,
          "Memory for the portals' images that are read from the house [MiB], 0 to 1048576: "
          "those that the walk needs next are read in the background, those seen the "
          "longest ago give way, and a portal whose image is not there shows geometry; "
          "without it there is no limit, and all are read before the walk")
      ->type_name("MIB")
      ->check(limits(0, 1 << 20));
}

std::optional<std::size_t> memoryLimit(const std::optional<double>& mib, ImageSource source) {
  if (!mib) return std::nullopt;
  if (source == ImageSource::kOnDemand) {
    throw Error(ErrorKind::kUsage, "--memory",
                "is for images of the house; of those that --images on-demand makes, 256 MiB are "
                "kept a method");
  }
  return static_cast<std::size_t>(std::llround(*mib * (1 << 20)));
}

}  // namespace enfilade
