#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace enfilade {

/// Where the program ffmpeg is, by PATH.  Throws Error (kMachine) that says how to install it.
std::string findFfmpeg();

/// A running ffmpeg that reads its standard input from us.  No shell is between, so that names may
/// hold anything.
class FfmpegPipe {
 public:
  /// `program`: as findFfmpeg() says.  Throws Error (kMachine).
  FfmpegPipe(const std::string& program, const std::vector<std::string>& arguments);
  ~FfmpegPipe();  ///< ends it if it was not finished
  FfmpegPipe(const FfmpegPipe&) = delete;
  FfmpegPipe& operator=(const FfmpegPipe&) = delete;

  /// Waits until ffmpeg took the bytes.  Throws Error (kMachine) with ffmpeg's last line when it
  /// ended, Interrupted when that is asked for.
  void write(std::span<const std::uint8_t> bytes);

  /// Has ffmpeg stand still, so that what is timed meanwhile has the machine to itself.
  void halt() noexcept;
  void goOn() noexcept;

  /// Ends its input and waits until it has done its work.  Throws as write() does.
  void finish();

 private:
  int wait();                ///< until it ended; its status, as waitpid() has it
  [[noreturn]] void fail();  ///< for the reason that it gave
  void close() noexcept;
  std::string lastMessage() const;

  pid_t process_ = -1;  ///< -1 once it ended
  int status_ = 0;      ///< of the end
  int input_ = -1;      ///< our end of its standard input
  int messages_ = -1;   ///< what it writes to its standard error, in memory
};

}  // namespace enfilade
