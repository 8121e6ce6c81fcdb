#pragma once

#include <string>

namespace enfilade {

/// A result: to stdout, at once.  Throws Error (kMachine) if it cannot be written.
void printResult(const std::string& text);

/// A message for the person who waits: one line to stderr, unless `quiet`.
void printNote(bool quiet, const std::string& line);

/// `arguments` as a shell would take them, quoted where they need it.
std::string shellLine(int argc, char** argv);

}  // namespace enfilade
