#include "app/staged_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "scene/error.h"

namespace enfilade {

namespace {

namespace fs = std::filesystem;

/// Without the slashes at its end, so that a name can be put after it.
std::string trimmed(std::string folder) {
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  return folder;
}

void refuseWhatIsNotOurs(const std::string& folder, const std::string& proof) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(folder, error);
  if (!fs::exists(status)) return;
  if (fs::is_directory(status)) {
    if (fs::exists(folder + "/" + proof, error)) return;
    if (fs::is_empty(folder, error) && !error) return;
  }
  throw Error(ErrorKind::kUsage, folder,
              "is there already and holds no " + proof + "; name another folder, or remove it");
}

[[noreturn]] void throwMachine(const std::string& folder, const std::error_code& error) {
  throw Error(ErrorKind::kMachine, folder, "cannot be written: " + error.message());
}

}  // namespace

StagedFolder::StagedFolder(const std::string& folder, const std::string& proof)
    : folder_(trimmed(folder)), temporary_(fmt::format("{}.tmp-{}", folder_, getpid())) {
  refuseWhatIsNotOurs(folder_, proof);
  std::error_code error;
  const fs::path parent = fs::path(folder_).parent_path();
  if (!parent.empty()) fs::create_directories(parent, error);
  if (!error) fs::create_directory(temporary_, error);
  if (error) throwMachine(folder_, error);
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(temporary_, ignored);
}

void StagedFolder::commit() {
  std::error_code error;
  const std::string old = fmt::format("{}.old-{}", folder_, getpid());
  const bool replaces = fs::exists(folder_);
  if (replaces) fs::rename(folder_, old, error);
  if (error) throwMachine(folder_, error);
  fs::rename(temporary_, folder_, error);
  if (error) {
    std::error_code ignored;
    if (replaces) fs::rename(old, folder_, ignored);
    throwMachine(folder_, error);
  }
  committed_ = true;
  if (replaces) fs::remove_all(old, error);
}

}  // namespace enfilade
