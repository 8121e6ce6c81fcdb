#pragma once

#include <string>

namespace enfilade {

/// Parses the command line and runs the subcommand that it names.  Returns the exit status (0).
/// Throws Error (kUsage) for a command line that makes no sense, and what the subcommand throws.
int runProgram(int argc, char** argv);

/// Prints "enfilade: MESSAGE" to stderr, as one line whatever `message` holds.
void printError(const std::string& message);

}  // namespace enfilade
