#include "tests/app/virtual_screen.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "tests/app/temporary_folder.h"

namespace enfilade {

namespace {

using Clock = std::chrono::steady_clock;

void nap() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }

Clock::time_point after(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

BackgroundProcess::BackgroundProcess(const std::vector<std::string>& arguments,
                                     const std::string& output,
                                     const std::vector<std::string>& environment) {
  pid_ = fork();
  if (pid_ != 0) return;
  const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  dup2(file, 1);
  dup2(file, 2);
  for (const std::string& setting : environment) putenv(const_cast<char*>(setting.c_str()));
  std::vector<char*> words;
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execvp(words[0], words.data());
  _exit(127);
}

BackgroundProcess::~BackgroundProcess() {
  if (!runs()) return;
  kill(pid_, SIGTERM);
  if (wait(5) == -1) kill(pid_, SIGKILL), wait(5);
}

int BackgroundProcess::wait(double seconds) {
  const Clock::time_point end = after(seconds);
  while (status_ == -1) {
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    } else if (Clock::now() >= end) {
      break;
    } else {
      nap();
    }
  }
  return status_;
}

void BackgroundProcess::send(int signal) const { kill(pid_, signal); }

bool VirtualScreen::available() {
  return std::system("command -v Xvfb >/dev/null && command -v xdotool >/dev/null") == 0;
}

VirtualScreen::VirtualScreen(int width, int height, const std::string& folder) : folder_(folder) {
  const std::string number = folder + "/display",
                    size = std::to_string(width) + "x" + std::to_string(height) + "x24";
  // It takes a number that is free, and writes it once it is ready.
  server_ = std::make_unique<BackgroundProcess>(
      std::vector<std::string>{"sh", "-c",
                               "exec Xvfb -displayfd 3 -screen 0 " + size +
                                   " -nolisten tcp -noreset 3>'" + number + "'"},
      folder + "/xvfb.log");
  for (const Clock::time_point end = after(20); Clock::now() < end && server_->runs(); nap()) {
    const std::string text = textOf(number);
    if (text.empty() || text.back() != '\n') continue;
    display_ = ":" + text.substr(0, text.size() - 1);
    return;
  }
}

bool VirtualScreen::act(const std::string& commands) const {
  const std::string line =
      "DISPLAY=" + display_ + " xdotool " + commands + " >>'" + folder_ + "/xdotool.log' 2>&1";
  return std::system(line.c_str()) == 0;
}

bool VirtualScreen::waitForWindow(const std::string& title, double seconds) const {
  for (const Clock::time_point end = after(seconds); Clock::now() < end; nap()) {
    if (act("search --onlyvisible --name '^" + title + "$'")) return true;
  }
  return false;
}

}  // namespace enfilade
