#include "preprocess/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "scene/error.h"

namespace enfilade {

FolderLock::FolderLock(const std::string& folder)
    : fd_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (fd_ < 0) {
    if (errno == ENOENT) return;
    throw Error(ErrorKind::kMachine, folder,
                std::string("cannot be opened: ") + std::strerror(errno));
  }
  if (::flock(fd_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(fd_);
  throw Error(
      ErrorKind::kMachine, folder,
      "is in use: another enfilade preprocess is at work there; wait for its end, or choose "
      "another folder");
}

FolderLock::~FolderLock() {
  if (fd_ >= 0) ::close(fd_);
}

bool FolderLock::holds(const std::string& folder) const {
  struct stat mine {};
  struct stat there {};
  return fd_ >= 0 && ::fstat(fd_, &mine) == 0 && ::stat(folder.c_str(), &there) == 0 &&
         mine.st_dev == there.st_dev && mine.st_ino == there.st_ino;
}

}  // namespace enfilade
