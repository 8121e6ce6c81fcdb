#include "tests/app/run_program.h"

#include <sys/wait.h>

#include <cstdlib>

#include "tests/app/temporary_folder.h"

namespace enfilade {

namespace {

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

ProgramResult runEnfilade(const std::vector<std::string>& arguments, const std::string& folder) {
  const TemporaryFolder streams;
  std::string line = "cd " + quoted(folder) + " && exec " + quoted(ENFILADE_PROGRAM);
  for (const std::string& argument : arguments) line += " " + quoted(argument);
  line += " </dev/null >" + quoted(streams / "out") + " 2>" + quoted(streams / "err");
  const int status = std::system(line.c_str());
  ProgramResult result;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.output = textOf(streams / "out");
  result.errors = textOf(streams / "err");
  return result;
}

}  // namespace enfilade
