#include "tests/app/running_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace enfilade {

namespace {

[[noreturn]] void become(const std::vector<std::string>& arguments, const std::string& folder,
                         const std::string& errors, const std::function<void()>& prepare) {
  const int null = open("/dev/null", O_WRONLY);
  const int messages = open(errors.c_str(), O_WRONLY | O_CREAT, 0600);
  dup2(null, STDOUT_FILENO);
  dup2(messages, STDERR_FILENO);
  if (chdir(folder.c_str()) != 0) _exit(127);
  std::vector<char*> argv = {const_cast<char*>("enfilade")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  if (prepare) prepare();
  execv(ENFILADE_PROGRAM, argv.data());
  _exit(127);
}

int statusOf(int wait_status) {
  return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, const std::string& folder,
                               const std::function<void()>& prepare)
    : child_(fork()) {
  if (child_ == 0) become(arguments, folder, streams_ / "err", prepare);
}

RunningProgram::~RunningProgram() {
  send(SIGKILL);
  wait();
}

bool RunningProgram::waitUntil(const std::function<bool()>& condition) {
  for (int i = 0; i < 6000 && !ended(); ++i) {
    if (condition()) return true;
    usleep(10'000);
  }
  return false;
}

void RunningProgram::send(int signal) const {
  if (status_ < 0) kill(child_, signal);
}

int RunningProgram::wait() {
  int status = 0;
  if (status_ < 0 && waitpid(child_, &status, 0) == child_) status_ = statusOf(status);
  return status_;
}

bool RunningProgram::ended() {
  int status = 0;
  if (status_ < 0 && waitpid(child_, &status, WNOHANG) == child_) status_ = statusOf(status);
  return status_ >= 0;
}

}  // namespace enfilade
