#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace enfilade {

/// `json` as text for people: indented, but what fits into 100 columns on one line, and arrays of
/// numbers wrapped.
/// Text that is not UTF-8 is mended.  The same text for the same value; ends with a line feed.
std::string jsonText(const nlohmann::ordered_json& json);

/// The double nearest to the shortest decimal that stands for `value`: prints as 0.1, not as
/// 0.10000000149011612, and reads back as the same float.
double shortDecimal(float value);

}  // namespace enfilade
