#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace enfilade {

/// One page that needs nothing else and opens offline: `page` with the style, the chart library and
/// `scripts` in it, run in their order, and `data` for them to show.  `words` stand where no script
/// runs.  Nothing in `data` or `words` can end what it stands in.
std::string assembledPage(std::string_view page, std::initializer_list<std::string_view> scripts,
                          const nlohmann::ordered_json& data, const std::string& words);

}  // namespace enfilade
