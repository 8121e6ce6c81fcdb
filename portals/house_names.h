#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "portals/house.h"

namespace enfilade {

/// How the kinds are written in house.json.
inline constexpr std::array<std::pair<PortalKind, std::string_view>, 3> kPortalKindNames = {{
    {PortalKind::kOpening, "opening"},
    {PortalKind::kDoor, "door"},
    {PortalKind::kWindow, "window"},
}};

/// "opening", "door" or "window".
constexpr std::string_view kindName(PortalKind kind) {
  for (const auto& [named, name] : kPortalKindNames) {
    if (named == kind) return name;
  }
  return kPortalKindNames[0].second;
}

/// The roles that house.json lists objects of; all others are fixed.
inline constexpr std::array<std::pair<ObjectRole, std::string_view>, 2> kListedRoleNames = {{
    {ObjectRole::kDoor, "door"},
    {ObjectRole::kGlass, "glass"},
}};

}  // namespace enfilade
