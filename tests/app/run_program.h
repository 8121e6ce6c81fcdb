#pragma once

#include <string>
#include <vector>

namespace enfilade {

/// What the built program did.
struct ProgramResult {
  int status = -1;     ///< exit status; 128 and more: ended by a signal
  std::string output;  ///< of stdout
  std::string errors;  ///< of stderr
};

/// Runs `enfilade ARGUMENTS...` in `folder` and waits for it.
ProgramResult runEnfilade(const std::vector<std::string>& arguments, const std::string& folder);

}  // namespace enfilade
