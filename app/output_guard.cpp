#include "app/output_guard.h"

#include <filesystem>

#include "app/path_within.h"
#include "app/report_folder.h"
#include "preprocess/house_entries.h"
#include "scene/error.h"

namespace enfilade {

namespace {

namespace fs = std::filesystem;

/// Whether `output` is, or lies in, what stands in a house or report of that name.
bool isPartOf(const std::string& folder, const std::string& output) {
  const fs::path within = pathWithin(folder, output);
  if (within.empty()) return false;
  const std::string first = within.begin()->string();
  return houseEntries().contains(first) || reportFolder().own.contains(first);
}

}  // namespace

void refuseToReplace(const std::string& output, const std::string& input) {
  if (output.empty()) return;
  std::error_code error;
  const bool is_same = fs::equivalent(output, input, error) && !error;
  if (!is_same && !(fs::is_directory(input, error) && isPartOf(input, output))) return;
  throw Error(ErrorKind::kUsage, output,
              "would be replaced, and is read; name another file to write");
}

}  // namespace enfilade
