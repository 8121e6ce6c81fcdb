#include "app/staged_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "scene/error.h"

namespace enfilade {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& file, const std::string& reason) {
  throw Error(ErrorKind::kMachine, file, "cannot be written: " + reason);
}

}  // namespace

StagedFile::StagedFile(const std::string& file) : file_(file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) fail(file, "is a directory");
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(file, "is not a regular file");
  // A symbolic link stays one: what it points to is replaced.
  if (fs::exists(status) && fs::is_symlink(fs::symlink_status(file, error))) {
    file_ = fs::canonical(file, error).string();
  }
  temporary_ = fmt::format("{}.tmp-{}", file_, getpid());
  const int fd = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (fd < 0) fail(file, std::strerror(errno));
  ::close(fd);
}

StagedFile::~StagedFile() {
  if (!committed_) ::unlink(temporary_.c_str());
}

void StagedFile::commit() {
  if (::rename(temporary_.c_str(), file_.c_str()) != 0) fail(file_, std::strerror(errno));
  committed_ = true;
}

}  // namespace enfilade
