#pragma once

#include <string>

namespace enfilade {

/// Cuts a name to its first 1,000 bytes, or a character less: names are kept once for each part of
/// what they are the name of.
inline void shortenName(std::string& name) {
  constexpr std::size_t kLongest = 1000;
  if (name.size() <= kLongest) return;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;  // UTF-8
  name.resize(end);
  name.shrink_to_fit();
}

}  // namespace enfilade
