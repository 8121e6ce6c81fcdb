#include "scene/format_version.h"

#include <fmt/format.h>

namespace enfilade {

std::string otherFormatVersion(double found, double ours) {
  if (found < ours) {
    return fmt::format(
        "is of format version {}, older than version {} that this program reads: preprocess the "
        "model again",
        found, ours);
  }
  return fmt::format(
      "is of format version {}, newer than version {} that this program reads: use a newer "
      "enfilade, or preprocess the model again with this one",
      found, ours);
}

}  // namespace enfilade
