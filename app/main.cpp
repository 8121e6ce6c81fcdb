#include <fcntl.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "app/interruption.h"
#include "app/program.h"
#include "scene/error.h"

namespace {

/// So that no file of ours gets the number of a stream that is closed, and what is said into it.
void occupyClosedStreams() {
  for (int fd = 0; fd <= 2; ++fd) {
    if (fcntl(fd, F_GETFD) < 0) (void)open("/dev/null", O_RDONLY);  // writing to it still fails
  }
}

}  // namespace

int main(int argc, char** argv) {
  occupyClosedStreams();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on files is told like a full disk
  enfilade::endTidily();
  try {
    return enfilade::runProgram(argc, argv);
  } catch (const enfilade::Error& error) {
    enfilade::printError(error.what());
    return static_cast<int>(error.kind());
  } catch (const enfilade::Interrupted& interrupted) {
    enfilade::endBy(interrupted);
  } catch (const std::bad_alloc&) {
    enfilade::printError("out of memory");
  } catch (const std::exception& error) {
    enfilade::printError(error.what());
  }
  return static_cast<int>(enfilade::ErrorKind::kMachine);
}
