#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "portals/cell_graph.h"

namespace enfilade {

struct House;

/// The XXH3 64 of each file of a house but house.json, which lists them, by its name in the folder:
/// "geometry.glb", "images/portal-0000-front/ldi.bin".
using HouseFiles = std::map<std::string, std::uint64_t>;

/// What a house.json has at most [bytes].
inline constexpr std::uint64_t kMostHouseJsonBytes = std::uint64_t{1} << 30;

/// Paths of the files in a house folder.
std::string houseJsonFile(const std::string& folder);
std::string geometryFile(const std::string& folder);
std::string cellGridFile(const std::string& folder);
/// folder/images/portal-PPPP-front or -back: what is seen by a viewer on that side.
std::string portalImageFolder(const std::string& folder, PortalId portal, bool from_front);
/// The folder in a house folder where a house is made that is not yet finished.
std::string unfinishedFolder(const std::string& folder);

/// The name that a house lists an image of a portal's side by: "images/portal-0000-front/FILE".
std::string portalImageName(PortalId portal, bool from_front, const std::string& file);

/// What a house lists its files by.
std::uint64_t fileChecksum(std::span<const std::uint8_t> bytes);

/// Whether the house lists the file `name`.
bool hasFile(const House& house, const std::string& name);

/// The bytes of the file `name` that the house in `folder` lists, proved to be those that were
/// written with it.  Throws Error (kBadInput) that names the file: missing, or cut short, damaged,
/// or of another house, portal or side.
std::vector<std::uint8_t> readHouseFile(const House& house, const std::string& folder,
                                        const std::string& name);

/// Throws Error (kBadInput) that names the first file that the house lists and that is not there.
void requireFiles(const House& house, const std::string& folder);

}  // namespace enfilade
