#pragma once

#include <string>

namespace enfilade {

/// `text` (UTF-8) with blanks for what would move a terminal's cursor, command it or turn the order
/// of its letters: control characters, line ends among them, and Unicode's directional ones.
std::string printable(std::string text);

}  // namespace enfilade
