#include "scene/model_folder.h"

#include <algorithm>

#include "scene/error.h"
#include "scene/warning_log.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

/// "http://…", "file:…"; a mere colon may stand in a file's name.
bool isAddress(const std::string& name) {
  return name.find("://") != std::string::npos || name.starts_with("file:");
}

}  // namespace

fs::path fileInModelFolder(const std::string& model_file, const std::string& name) {
  const auto fail = [&](const std::string& reason) {
    throw Error(ErrorKind::kBadInput, model_file, "\"" + oneLine(name) + "\" " + reason);
  };
  if (isAddress(name)) fail("is an address; only files beside the model are read");
  if (name.empty() || name.find('\0') != std::string::npos) fail("is no file name");
  std::string found = name;
  std::error_code error;
  fs::path parent = fs::path(model_file).parent_path();
  const fs::path folder = fs::canonical(parent.empty() ? "." : parent, error);
  // Some exporters write the other system's separator.
  if (!error && !fs::exists(folder / found, error)) {
    std::replace(found.begin(), found.end(), '\\', '/');
    error.clear();
  }
  const fs::path path = error ? fs::path() : fs::weakly_canonical(folder / found, error);
  if (error) fail("cannot be found: " + error.message());
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  if (end != folder.end()) fail("lies outside the model's own folder");
  return path;
}

}  // namespace enfilade
