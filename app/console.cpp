#include "app/console.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "app/interruption.h"
#include "scene/error.h"
#include "scene/printable.h"

namespace enfilade {

void printResult(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    if (errno == EPIPE) Interruption::throwIfAsked();
    throw Error(ErrorKind::kMachine, "standard output",
                std::string("cannot be written: ") + std::strerror(errno));
  }
}

void printNote(bool quiet, const std::string& line) {
  if (!quiet) std::fprintf(stderr, "%s\n", printable(line).c_str());
}

std::string shellLine(int argc, char** argv) {
  std::string line;
  for (int i = 0; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool plain = !argument.empty() && argument.find_first_not_of(
                                                "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRST"
                                                "UVWXYZ0123456789_-./,:=+@%") == std::string::npos;
    if (i > 0) line += ' ';
    if (plain) {
      line += argument;
      continue;
    }
    line += '\'';
    for (const char c : argument) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace enfilade
