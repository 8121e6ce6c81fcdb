#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace enfilade {

/// Gathers what a reader mends: the same thing in a thousand meshes is one line.
class WarningLog {
 public:
  /// `what` happened to `subject`, "mesh 'Door'".
  void add(const std::string& what, const std::string& subject);

  /// A line for each `what`, in the order of their first mention: "WHAT: SUBJECT and 7 more".
  std::vector<std::string> lines() const;

  /// The first line as the end of a message: ": WHAT: SUBJECT"; empty without any.
  std::string because() const;

 private:
  struct Entry {
    std::string what;
    std::string first_subject;
    std::size_t count = 0;
  };
  std::vector<Entry> entries_;
};

/// `text` in one line of at most `length` bytes, fit for a message: control characters as spaces,
/// what is cut off as "...".
std::string oneLine(const std::string& text, std::size_t length = 80);

}  // namespace enfilade
