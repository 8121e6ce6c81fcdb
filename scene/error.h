#pragma once

#include <stdexcept>
#include <string>

namespace enfilade {

/// What kind of failure; the values are the program's exit statuses.
enum class ErrorKind { kUsage = 1, kBadInput = 2, kMachine = 3 };

/// The one exception of the project: bad usage, bad input, or a machine that cannot.
/// `what()` is "SUBJECT: REASON": one line, for the person who made the file named in `subject`.
/// What would move a terminal's cursor becomes blanks, for files put names of their own into both.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& subject, const std::string& reason);

  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace enfilade
