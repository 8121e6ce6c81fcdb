#include "app/staged_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace {

namespace fs = std::filesystem;

/// Without the slashes at its end, so that a name can be put after it.
std::string trimmed(std::string folder) {
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  return folder;
}

void refuseWhatIsNotOurs(const std::string& folder, const std::set<std::string>& proof) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(folder, error);
  if (!fs::exists(status)) return;
  const auto lacking = std::find_if(proof.begin(), proof.end(), [&](const std::string& file) {
    return !fs::exists(folder + "/" + file, error);
  });
  if (fs::is_directory(status)) {
    if (lacking == proof.end()) return;
    if (fs::is_empty(folder, error) && !error) return;
  }
  throw Error(ErrorKind::kUsage, folder,
              "is there already and holds no " +
                  (lacking != proof.end() ? *lacking : *proof.begin()) +
                  "; name another folder, or remove it");
}

bool isMountPoint(const std::string& folder) {
  struct statx status {};
  return statx(AT_FDCWD, folder.c_str(), AT_SYMLINK_NOFOLLOW, STATX_BASIC_STATS, &status) == 0 &&
         (status.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

/// What no other folder can take the place of, told before the long work, not after it.
void refuseWhatCannotMove(const std::string& folder) {
  std::error_code error;
  const bool is_here = fs::equivalent(folder, fs::current_path(error), error) && !error;
  if (!is_here && !isMountPoint(folder)) return;
  throw Error(ErrorKind::kUsage, folder,
              std::string(is_here ? "is the folder that you are in" : "is a mount point") +
                  ", which cannot be replaced; name a folder in it");
}

/// Of a link to a folder, and of a folder without a name of its own ("reports/.."), the one meant.
std::string meant(const std::string& folder) {
  std::error_code error;
  const std::string last = fs::path(folder).filename().string();
  const bool is_link = fs::is_symlink(fs::symlink_status(folder, error));
  if (!is_link && last != "." && last != "..") return folder;
  const fs::path own = fs::canonical(folder, error);
  return error ? folder : own.string();
}

[[noreturn]] void throwMachine(const std::string& folder, const std::error_code& error) {
  throw Error(ErrorKind::kMachine, folder, "cannot be written: " + error.message());
}

}  // namespace

StagedFolder::StagedFolder(const std::string& folder, FolderKind kind)
    : folder_(meant(trimmed(folder))), kind_(std::move(kind)) {
  refuseWhatIsNotOurs(folder_, kind_.proof);
  refuseWhatCannotMove(folder_);
  std::error_code error;
  replaces_ = fs::exists(folder_, error);
  const fs::path parent = fs::path(folder_).parent_path();
  if (!parent.empty()) fs::create_directories(parent, error);
  if (error) throwMachine(folder_, error);
  temporary_ = createTemporaryFolder(folder_);
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(temporary_, ignored);
}

std::string StagedFolder::asCommitted(std::string message) const {
  const std::size_t at = committed_ ? std::string::npos : message.find(temporary_);
  return at == std::string::npos ? message : message.replace(at, temporary_.size(), folder_);
}

void StagedFolder::commit() {
  std::error_code error;
  if (replaces_ && fs::exists(folder_, error)) {
    replaceOld();
  } else {
    commitAsNew();
  }
}

void StagedFolder::commitAsNew() {
  if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, folder_.c_str(), RENAME_NOREPLACE) == 0) {
    committed_ = true;
    return;
  }
  std::error_code error(errno, std::generic_category());
  if (fs::exists(fs::symlink_status(folder_, error))) {
    committed_ = true;  // all of it, but for the name
    throw Error(
        ErrorKind::kMachine, folder_,
        "was not there before, and is not replaced: what was to stand there is in " + temporary_);
  }
  error.clear();
  fs::rename(temporary_, folder_, error);  // of file systems that know no other way
  if (error) throwMachine(folder_, error);
  committed_ = true;
}

void StagedFolder::replaceOld() {
  std::error_code error;
  std::string old = temporary_;  // once they have changed places
  if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, folder_.c_str(), RENAME_EXCHANGE) != 0) {
    old = fmt::format("{}.old-{}", folder_, getpid());
    fs::rename(folder_, old, error);
    if (error) throwMachine(folder_, error);
    fs::rename(temporary_, folder_, error);
    if (error) {
      std::error_code ignored;
      fs::rename(old, folder_, ignored);
      throwMachine(folder_, error);
    }
  }
  committed_ = true;
  for (const auto& entry : fs::directory_iterator(old, error)) {
    const std::string name = entry.path().filename().string();
    const std::string kept = folder_ + "/" + name;
    if (kind_.own.contains(name) || fs::exists(fs::symlink_status(kept, error))) continue;
    fs::rename(entry.path(), kept, error);
    if (error) break;
  }
  if (!error) fs::remove_all(old, error);
  if (error) {
    throw Error(ErrorKind::kMachine, old,
                "is what was there before, and cannot be removed: " + error.message());
  }
}

}  // namespace enfilade
