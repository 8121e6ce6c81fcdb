#include "preprocess/claim_rooms.h"

#include <algorithm>
#include <map>
#include <utility>

namespace enfilade {

namespace {

constexpr std::uint16_t kNobody = CellProposal::kNobody;
constexpr float kReach = 2.0f;  // how far above an empty node its room may begin [m]

/// How many voxels found rooms and the author's share.
struct Shares {
  std::vector<std::size_t> found;     ///< one a found room: its voxels
  std::vector<std::size_t> authored;  ///< one an author's room: its voxels that any found room has
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::size_t> both;  ///< by found and author's
};

Shares countShares(const std::vector<std::uint16_t>& found, std::size_t founds,
                   const std::vector<std::uint16_t>& authored, std::size_t rooms) {
  Shares shares;
  shares.found.resize(founds);
  shares.authored.resize(rooms + 1);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] == kNobody) continue;
    ++shares.found[found[i]];
    if (authored[i] == kNobody) continue;
    ++shares.authored[authored[i]];
    ++shares.both[{found[i], authored[i]}];
  }
  return shares;
}

/// Who gets the voxels of a found room.
struct Claims {
  std::uint16_t all = kNobody;       ///< the author's room that gets it as a whole
  std::vector<std::uint16_t> parts;  ///< those that get what lies in their bounds
  bool shared_out = false;           ///< the parts are most of it: the rest grows from them
};

std::vector<Claims> claimsOf(const Shares& shares) {
  std::vector<Claims> claims(shares.found.size());
  std::vector<std::size_t> most(shares.found.size(), 0), parts(shares.found.size(), 0);
  for (const auto& [pair, count] : shares.both) {
    const auto& [found, room] = pair;
    if (found != kExterior && 2 * count >= shares.found[found] && count > most[found]) {
      claims[found].all = room;
      most[found] = count;
    }
  }
  for (const auto& [pair, count] : shares.both) {
    const auto& [found, room] = pair;
    if (claims[found].all == room || 2 * count < shares.authored[room]) continue;
    claims[found].parts.push_back(room);
    parts[found] += count;
  }
  for (std::size_t f = 0; f < claims.size(); ++f) {
    claims[f].shared_out = f != kExterior && 2 * parts[f] >= shares.found[f];
  }
  return claims;
}

/// The found room that a point stands in, or below.
std::uint16_t foundAt(const VoxelGrid& voxels, const CellProposal& found, const glm::vec3& p) {
  const int steps = static_cast<int>(kReach / voxels.voxel);
  for (int step = 0; step <= steps; ++step) {
    const glm::ivec3 v = voxels.voxelOf(p) + glm::ivec3(0, step, 0);
    if (!voxels.contains(v)) break;
    const std::uint16_t cell = found.owner[voxels.index(v.x, v.y, v.z)];
    if (cell != kNobody) return cell;
  }
  return kNobody;
}

void claimByEmptyNodes(const AuthoredNames& names, const VoxelGrid& voxels,
                       const CellProposal& found, std::vector<Claims>& claims) {
  for (std::size_t r = 0; r < names.rooms.size(); ++r) {
    if (!names.rooms[r].bounds.empty()) continue;
    const std::uint16_t cell = foundAt(voxels, found, names.rooms[r].position);
    if (cell == kNobody || cell == kExterior || claims[cell].all != kNobody) continue;
    claims[cell].all = static_cast<std::uint16_t>(r + 1);
  }
}

/// The storey on whose floor a room stands.
int storeyOf(const AuthoredNames::Room& room, const std::vector<Storey>& storeys) {
  const float y = room.bounds.empty() ? room.position.y : room.bounds.min.y;
  int storey = 0;
  for (std::size_t s = 0; s < storeys.size(); ++s) {
    if (storeys[s].floor_y <= y + 0.3f) storey = static_cast<int>(s);
  }
  return storey;
}

/// The cells that there are now, and which of them each found one is.
struct Numbering {
  std::vector<std::string> names{std::string()};
  std::vector<int> storeys{0};
  std::vector<std::uint16_t> of_found;    ///< kNobody: given to those who claim parts
  std::vector<std::uint8_t> has_claimed;  ///< one an author's room, [0] nobody's
};

Numbering numberCells(const AuthoredNames& names, const CellProposal& found,
                      const std::vector<Claims>& claims) {
  Numbering cells;
  cells.of_found.assign(claims.size(), kNobody);
  cells.of_found[kExterior] = kExterior;
  cells.has_claimed.assign(names.rooms.size() + 1, 0);
  for (const AuthoredNames::Room& room : names.rooms) {
    cells.names.push_back(room.name);
    cells.storeys.push_back(storeyOf(room, found.storeys));
  }
  for (std::size_t f = 0; f < claims.size(); ++f) {
    for (const std::uint16_t room : claims[f].parts) cells.has_claimed[room] = 1;
    if (f == kExterior) continue;
    if (claims[f].all != kNobody) {
      cells.of_found[f] = claims[f].all;
      cells.has_claimed[claims[f].all] = 1;
    } else if (!claims[f].shared_out) {
      cells.of_found[f] = static_cast<std::uint16_t>(cells.storeys.size());
      cells.names.emplace_back();
      cells.storeys.push_back(found.cell_storeys[f]);
    }
  }
  return cells;
}

}  // namespace

void claimRooms(const AuthoredNames& names, const CellProposal& authored, const VoxelGrid& voxels,
                CellProposal& found) {
  const Shares shares =
      countShares(found.owner, found.cell_storeys.size(), authored.owner, names.rooms.size());
  std::vector<Claims> claims = claimsOf(shares);
  claimByEmptyNodes(names, voxels, found, claims);
  Numbering cells = numberCells(names, found, claims);
  for (std::size_t i = 0; i < found.owner.size(); ++i) {
    const std::uint16_t room = authored.owner[i];
    std::uint16_t& cell = found.owner[i];
    if (cell == kNobody) {
      if (room != kNobody && !cells.has_claimed[room]) cell = room;
      continue;
    }
    const auto& parts = claims[cell].parts;
    const bool part = room != kNobody && std::find(parts.begin(), parts.end(), room) != parts.end();
    cell = part ? room : cells.of_found[cell];
  }
  found.cell_names = std::move(cells.names);
  found.cell_storeys = std::move(cells.storeys);
}

}  // namespace enfilade
