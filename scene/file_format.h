#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace enfilade {

/// What a file of another format than was asked for seems to be, for an error message: "it seems to
/// be an IFC or STEP file; convert it to glTF first", or how it begins.
std::string guessFormat(std::span<const std::uint8_t> bytes);

}  // namespace enfilade
