#include "app/ffmpeg_pipe.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "app/interruption.h"
#include "scene/error.h"

extern char** environ;

namespace enfilade {

namespace {

[[noreturn]] void failBy(const std::string& reason) {
  throw Error(ErrorKind::kMachine, "ffmpeg", reason);
}

bool isProgram(const std::string& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
         ::access(file.c_str(), X_OK) == 0;
}

/// Starts `program` with these as its standard input and error; its output goes to the latter too.
/// It gets a group of its own, so that Ctrl-C is ours alone to answer.
pid_t start(const std::string& program, const std::vector<std::string>& arguments, int input,
            int messages) {
  std::vector<char*> argv;
  argv.push_back(const_cast<char*>(program.c_str()));  // NOLINT
  for (const std::string& text : arguments)
    argv.push_back(const_cast<char*>(text.c_str()));  // NOLINT
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = -1;
  const int error =
      posix_spawn(&process, program.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) failBy(fmt::format("cannot be started: {}", std::strerror(error)));
  return process;
}

}  // namespace

std::string findFfmpeg() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = folder + "/ffmpeg";
    if (!folder.empty() && isProgram(file)) return file;
  }
  failBy("is not there, and films are made by it: apt-get install ffmpeg");
}

FfmpegPipe::FfmpegPipe(const std::string& program, const std::vector<std::string>& arguments) {
  // A socket, since writing to one whose reader is gone can be told not to raise SIGPIPE.
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) failBy(std::strerror(errno));
  input_ = ends[0];
  // Its messages are kept in memory, as nobody reads them before it ends.
  messages_ = memfd_create("ffmpeg's messages", MFD_CLOEXEC);
  try {
    process_ = start(program, arguments, ends[1], messages_);
  } catch (...) {
    ::close(ends[1]);
    close();
    throw;
  }
  ::close(ends[1]);
}

FfmpegPipe::~FfmpegPipe() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  close();
}

void FfmpegPipe::close() noexcept {
  if (input_ >= 0) ::close(input_);
  if (messages_ >= 0) ::close(messages_);
  input_ = messages_ = -1;
}

void FfmpegPipe::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n < 0) Interruption::throwIfAsked();
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail();
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
}

void FfmpegPipe::halt() noexcept { kill(process_, SIGSTOP); }

void FfmpegPipe::goOn() noexcept { kill(process_, SIGCONT); }

void FfmpegPipe::finish() {
  ::close(input_);
  input_ = -1;
  if (wait() != 0) fail();
}

int FfmpegPipe::wait() {
  while (process_ > 0 && waitpid(process_, &status_, 0) < 0) {
    Interruption::throwIfAsked();
    if (errno != EINTR) failBy(fmt::format("cannot be waited for: {}", std::strerror(errno)));
  }
  process_ = -1;
  return status_;
}

void FfmpegPipe::fail() {
  const int status = wait();
  const std::string message = lastMessage();
  if (!message.empty()) failBy(message);
  if (WIFSIGNALED(status)) failBy(fmt::format("was ended by signal {}", WTERMSIG(status)));
  failBy(fmt::format("ended early with status {}", WEXITSTATUS(status)));
}

std::string FfmpegPipe::lastMessage() const {
  std::string text(static_cast<std::size_t>(std::max<off_t>(lseek(messages_, 0, SEEK_END), 0)), 0);
  if (pread(messages_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) return {};
  const std::size_t last = text.find_last_not_of(" \r\n");
  if (last == std::string::npos) return {};
  const std::size_t before = text.find_last_of("\r\n", last);
  return text.substr(before + 1, last - before);  // npos + 1 is 0
}

}  // namespace enfilade
