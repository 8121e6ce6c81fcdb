#include "scene/file_io.h"

#include <fcntl.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>

#include "scene/error.h"

namespace enfilade {
namespace {

std::string systemReason() { return std::strerror(errno); }

/// Closes what it holds.
class FileDescriptor {
 public:
  explicit FileDescriptor(int fd) : fd_(fd) {}
  ~FileDescriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  int get() const noexcept { return fd_; }
  /// The system's answer to close: the last moment at which a full disk is told.
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

[[noreturn]] void failRead(const std::string& file) {
  for (const int machine : {EMFILE, ENFILE, ENOMEM, EIO}) {
    if (errno == machine) {
      throw Error(ErrorKind::kMachine, file, "cannot be read: " + systemReason());
    }
  }
  if (errno == ENOENT || errno == ENOTDIR) throw Error(ErrorKind::kBadInput, file, "no such file");
  throw Error(ErrorKind::kBadInput, file, "cannot be read: " + systemReason());
}

bool writeAll(int fd, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return true;
}

/// What the system has given the process already, a pipe, a terminal or a file of a shell's: it is
/// written on, not replaced.
bool isGiven(const std::string& file) {
  return file == "/dev/stdout" || file == "/dev/stderr" || file.starts_with("/dev/fd/") ||
         file.starts_with("/proc/");
}

bool writeOn(const std::string& file, std::span<const std::uint8_t> bytes) {
  FileDescriptor fd(::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  return fd.get() >= 0 && writeAll(fd.get(), bytes) && fd.close();
}

/// The file that is meant where `file` is a symbolic link, perhaps to nothing yet.
std::string behindLinks(const std::string& file) {
  namespace fs = std::filesystem;
  constexpr int kMostLinks = 40;
  fs::path at = file;
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(at, error)); ++i) {
    const fs::path target = fs::read_symlink(at, error);
    if (error) return file;
    at = target.is_absolute() ? target : at.parent_path() / target;
  }
  return at.string();
}

bool writeWhole(const std::string& file, std::span<const std::uint8_t> bytes) {
  FileDescriptor fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  return fd.get() >= 0 && writeAll(fd.get(), bytes) && fd.close();
}

// The names of the temporary files that are being written, for a signal's handler.
std::array<std::atomic<const char*>, 64> half_written{};
static_assert(std::atomic<const char*>::is_always_lock_free);

/// Has a file known as half written while it lives; of very many at once not all.
class HalfWritten {
 public:
  explicit HalfWritten(const std::string& file) {
    for (auto& slot : half_written) {
      const char* none = nullptr;
      if (!slot.compare_exchange_strong(none, file.c_str())) continue;
      slot_ = &slot;
      return;
    }
  }
  ~HalfWritten() {
    if (slot_ != nullptr) *slot_ = nullptr;
  }
  HalfWritten(const HalfWritten&) = delete;
  HalfWritten& operator=(const HalfWritten&) = delete;

 private:
  std::atomic<const char*>* slot_ = nullptr;
};

[[noreturn]] void failWrite(const std::string& file, const std::string& reason) {
  throw Error(ErrorKind::kMachine, file, "cannot be written: " + reason);
}

/// Whoever might read or write an older file may the new one.
void keepMode(const std::string& file, const std::string& temporary) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) ::chmod(temporary.c_str(), status.st_mode & 07777);
}

/// The first of FILE.tmp-PID, FILE.tmp-PID-1, ... that `create` does not find there already.
template <typename Create>
std::string createNew(const std::string& file, Create&& create) {
  constexpr int kMost = 1000;  // that killed processes of the same number left
  const std::string name =
      file + std::string(kTemporaryMark) + std::to_string(static_cast<long>(::getpid()));
  std::string temporary = name;
  for (int n = 1; n <= kMost; ++n) {
    if (create(temporary.c_str())) return temporary;
    if (errno != EEXIST) break;
    temporary = name + "-" + std::to_string(n);
  }
  failWrite(file, systemReason());
}

}  // namespace

void removeHalfWrittenFiles() noexcept {
  for (const auto& slot : half_written) {
    if (const char* file = slot; file != nullptr) ::unlink(file);
  }
}

std::string createTemporary(const std::string& file) {
  return createNew(file, [](const char* name) {
    const int fd = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return fd >= 0 && ::close(fd) == 0;
  });
}

std::string createTemporaryFolder(const std::string& folder) {
  return createNew(folder, [](const char* name) { return ::mkdir(name, 0777) == 0; });
}

std::vector<std::uint8_t> readFile(const std::string& file, std::uint64_t most) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > most) {
    throw Error(ErrorKind::kBadInput, file,
                "is larger than " + std::to_string(most >> 20) + " MiB, too large for what it is");
  }
  return readFileStart(file, std::numeric_limits<std::size_t>::max());
}

std::vector<std::uint8_t> readFileStart(const std::string& file, std::size_t most) {
  // O_NONBLOCK: opening a pipe that nobody writes to must not hang.
  const FileDescriptor fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (fd.get() < 0) failRead(file);
  struct stat status {};
  if (::fstat(fd.get(), &status) != 0) failRead(file);
  if (S_ISDIR(status.st_mode)) throw Error(ErrorKind::kBadInput, file, "is a directory");
  if (!S_ISREG(status.st_mode)) throw Error(ErrorKind::kBadInput, file, "is not a regular file");

  std::vector<std::uint8_t> bytes(std::min(static_cast<std::size_t>(status.st_size), most));
  std::size_t size = 0;
  while (size < bytes.size()) {
    const ssize_t n = ::read(fd.get(), bytes.data() + size, bytes.size() - size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) failRead(file);
    if (n == 0) break;  // the file shrank meanwhile
    size += static_cast<std::size_t>(n);
  }
  bytes.resize(size);
  return bytes;
}

std::string targetOf(const std::string& file) {
  const std::string target = behindLinks(file);
  std::error_code error;
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(target, error))) {
    failWrite(file, "is a symbolic link that leads to itself");
  }
  return target;
}

void writeFileAtomically(const std::string& file, std::span<const std::uint8_t> bytes) {
  namespace fs = std::filesystem;
  if (file.empty()) throw Error(ErrorKind::kUsage, "", "the name of a file to write is empty");
  if (isGiven(file)) {
    if (!writeOn(file, bytes)) failWrite(file, systemReason());
    return;
  }
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) failWrite(file, "is a directory");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    // A device or a pipe must not be replaced by a file.
    if (!writeWhole(file, bytes)) failWrite(file, systemReason());
    return;
  }
  const std::string target = targetOf(file);
  const std::string temporary = createTemporary(target);
  const HalfWritten while_written(temporary);
  const bool written = writeWhole(temporary, bytes);
  if (written) keepMode(target, temporary);
  if (written && ::rename(temporary.c_str(), target.c_str()) == 0) return;
  const std::string reason = systemReason();
  ::unlink(temporary.c_str());
  failWrite(file, reason);
}

void writeFileAtomically(const std::string& file, const std::string& text) {
  writeFileAtomically(file,
                      std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void createFolders(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(ErrorKind::kMachine, folder, "cannot be created: " + error.message());
}

std::string sha256Hex(std::span<const std::uint8_t> bytes) {
  std::array<std::uint8_t, crypto_hash_sha256_BYTES> digest{};
  crypto_hash_sha256(digest.data(), bytes.data(), bytes.size());
  std::array<char, 2 * digest.size() + 1> hex{};
  sodium_bin2hex(hex.data(), hex.size(), digest.data(), digest.size());
  return hex.data();
}

}  // namespace enfilade
