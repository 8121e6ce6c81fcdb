#include "app/staged_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "scene/error.h"
#include "scene/file_io.h"

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
  file_ = targetOf(file);
  temporary_ = createTemporary(file_);
}

StagedFile::~StagedFile() {
  if (!committed_) ::unlink(temporary_.c_str());
}

void StagedFile::commit() {
  if (::rename(temporary_.c_str(), file_.c_str()) != 0) fail(file_, std::strerror(errno));
  committed_ = true;
}

}  // namespace enfilade
