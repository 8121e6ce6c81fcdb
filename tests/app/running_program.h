#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/app/temporary_folder.h"

namespace enfilade {

/// `enfilade ARGUMENTS...` under way in a folder, to be stopped.
class RunningProgram {
 public:
  /// `prepare` is called in the new process before the program.
  RunningProgram(const std::vector<std::string>& arguments, const std::string& folder,
                 const std::function<void()>& prepare = {});
  ~RunningProgram();  ///< kills it
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Waits until `condition` holds; false if the program ended before, or a minute has passed.
  bool waitUntil(const std::function<bool()>& condition);
  void send(int signal) const;
  /// Waits for the end: the exit status, or 128 and the signal that ended it.
  int wait();
  std::string errors() const { return textOf(streams_ / "err"); }  ///< of stderr, so far

 private:
  bool ended();

  TemporaryFolder streams_;
  pid_t child_;
  int status_ = -1;  ///< −1: it has not ended
};

}  // namespace enfilade
