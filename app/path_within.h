#pragma once

#include <filesystem>

namespace enfilade {

/// `path` as seen from `folder`, links followed in both as far as they are there: "pictures/x", or
/// "../x" for what lies outside.  Empty if that cannot be said.
inline std::filesystem::path pathWithin(const std::filesystem::path& folder,
                                        const std::filesystem::path& path) {
  std::error_code error;
  const auto real = [&](const std::filesystem::path& at) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(at, error), error);
  };
  return real(path).lexically_relative(real(folder));
}

}  // namespace enfilade
