#include "scene/durable.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "scene/error.h"

namespace enfilade {

namespace {

void syncPath(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = fd >= 0 && ::fsync(fd) == 0;
  const int reason = errno;
  if (fd >= 0) ::close(fd);
  // EINVAL: of a kind that has no disk behind it.
  if (synced || reason == EINVAL) return;
  throw Error(ErrorKind::kMachine, path,
              std::string("cannot be written: ") + std::strerror(reason));
}

}  // namespace

void syncFolder(const std::string& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file()) syncPath(entry.path().string());
  }
  syncPath(folder);
}

}  // namespace enfilade
