#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "app/interruption.h"
#include "app/program.h"
#include "scene/error.h"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on files is told like a full disk
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
