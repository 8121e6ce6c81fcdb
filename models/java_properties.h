#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace enfilade {

/// Reads Java's .properties: KEY=VALUE lines in ISO 8859-1 with \uXXXX escapes and \ at the end of
/// a line that goes on, # and ! comments.  Values as UTF-8; of a key that stands twice the last
/// one. Source: java.util.Properties, load().
std::map<std::string, std::string> readJavaProperties(std::span<const std::uint8_t> bytes);

}  // namespace enfilade
