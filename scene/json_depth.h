#pragma once

#include <string>
#include <string_view>

namespace enfilade {

/// JSON deeper than this is refused: what copies, compares or prints it does so recursively.
inline constexpr int kMaxJsonDepth = 100;

/// Throws Error (kBadInput) that names `file` if the JSON in `text` nests deeper than
/// kMaxJsonDepth.  Of text that is no JSON it says nothing.
void requireShallowJson(std::string_view text, const std::string& file);

}  // namespace enfilade
