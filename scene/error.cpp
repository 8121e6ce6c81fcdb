#include "scene/error.h"

#include "scene/warning_log.h"

namespace enfilade {
namespace {

/// Room for the longest path that a system takes and a reason.
constexpr std::size_t kLongestMessage = 6000;

}  // namespace

Error::Error(ErrorKind kind, const std::string& subject, const std::string& reason)
    : std::runtime_error(
          oneLine(subject.empty() ? reason : subject + ": " + reason, kLongestMessage)),
      kind_(kind) {}

}  // namespace enfilade
