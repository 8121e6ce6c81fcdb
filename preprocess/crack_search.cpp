#include "preprocess/crack_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <tuple>

#include "preprocess/random_sphere.h"
#include "render/parallel_for.h"

namespace enfilade {
namespace {

constexpr std::size_t kFirstRays = 2'000'000;  // of the first round, if the places' limits allow
constexpr std::size_t kLeastPerPlace = 1024;
constexpr std::size_t kMostPerPlace = 8192;
constexpr std::size_t kRaysPerLine = 192;
constexpr int kMostRounds = 12;
constexpr std::size_t kMostPlaces = 8000;  // in the first round
constexpr std::size_t kMostLines = 20000;  // in a later one
constexpr std::size_t kLinesPerBlock = 16;

/// `direction` turned aside by a random angle, up to a right one but mostly much less.
glm::vec3 turnedAside(const glm::vec3& direction, std::mt19937& random) {
  const float angle = 0.5f * std::numbers::pi_v<float> * std::exp2(-7.0f * randomUnit(random));
  const glm::vec3 aside = glm::cross(direction, randomDirection(random));
  const float length = glm::length(aside);
  if (!(length > 1e-3f)) return direction;
  return std::cos(angle) * direction + std::sin(angle) / length * aside;
}

/// Where in its cell a line to `aim` starts: as near as can be, since from all places on it the
/// same is seen, and nothing may stand between.
std::optional<glm::vec3> startBefore(const SightClaims& sight, CellId cell, const glm::vec3& aim,
                                     const glm::vec3& direction) {
  constexpr int kMostSteps = 40;
  const float step = 0.5f * sight.voxel();
  for (int i = 1; i < kMostSteps; ++i) {
    const glm::vec3 p = aim - static_cast<float>(i) * step * direction;
    if (sight.labelAt(p) == cell) return p;
  }
  return std::nullopt;
}

/// Lines through the crack that `line` passed.
void varyLine(const SightClaims& sight, const CrackLine& line, std::size_t rays,
              std::mt19937& random, Sighted& out) {
  const glm::vec3 direction = glm::normalize(line.end - line.start);
  for (std::size_t i = 0; i < rays; ++i) {
    const float through = line.solid_from + (line.solid_to - line.solid_from) * randomUnit(random);
    const float aside = sight.voxel() * std::exp2(-8.0f * randomUnit(random));
    const glm::vec3 aim = line.start + direction * through + aside * randomInCube(random);
    const glm::vec3 turned = turnedAside(direction, random);
    const auto start = startBefore(sight, line.claim.cell, aim, turned);
    if (start) sight.follow(line.claim.cell, *start, turned, out);
  }
}

/// The first of those lines that `less` calls equal, thinned evenly if they are too many.
template <class Less>
std::vector<CrackLine> oneOfEach(std::vector<CrackLine> lines, std::size_t most, Less less) {
  std::stable_sort(lines.begin(), lines.end(), less);
  const auto same = [&](const CrackLine& a, const CrackLine& b) { return !less(a, b); };
  lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
  if (lines.size() <= most) return lines;
  std::vector<CrackLine> some;
  for (std::size_t i = 0; i < most; ++i) {
    some.push_back(lines[i * lines.size() / most]);
  }
  return some;
}

/// One line for each claim that is new.
std::vector<CrackLine> newLines(std::vector<CrackLine> lines, const PatchCells& known) {
  std::erase_if(lines, [&](const CrackLine& line) {
    return std::binary_search(known.claims.begin(), known.claims.end(), line.claim);
  });
  return oneOfEach(std::move(lines), kMostLines,
                   [](const CrackLine& a, const CrackLine& b) { return a.claim < b.claim; });
}

/// What lines like these meet, block by block.
std::vector<Sighted> varyLines(const SightClaims& sight, const std::vector<CrackLine>& lines,
                               int round) {
  const std::size_t rays =
      round > 0 ? kRaysPerLine
                : std::clamp(kFirstRays / lines.size(), kLeastPerPlace, kMostPerPlace);
  std::vector<Sighted> found((lines.size() + kLinesPerBlock - 1) / kLinesPerBlock);
  parallelFor(found.size(), [&](std::size_t b) {
    std::mt19937 random(static_cast<unsigned>(round) * 0x9e3779b9u + static_cast<unsigned>(b));
    const std::size_t end = std::min(lines.size(), (b + 1) * kLinesPerBlock);
    for (std::size_t i = b * kLinesPerBlock; i < end; ++i) {
      varyLine(sight, lines[i], rays, random, found[b]);
    }
  });
  return found;
}

}  // namespace

std::vector<CrackLine> oneOfEachPlace(std::vector<CrackLine> lines, float voxel, std::size_t most) {
  const auto place = [&](const CrackLine& line) {
    const glm::vec3 direction = glm::normalize(line.end - line.start);
    const glm::vec3 middle = line.start + 0.5f * (line.solid_from + line.solid_to) * direction;
    const glm::ivec3 v(glm::floor(middle / voxel));
    return std::tuple(line.claim.cell, v.x, v.z, v.y);
  };
  return oneOfEach(std::move(lines), most,
                   [&](const CrackLine& a, const CrackLine& b) { return place(a) < place(b); });
}

void searchCracks(const SightClaims& sight, std::vector<CrackLine> lines, PatchCells& claims) {
  lines = oneOfEachPlace(std::move(lines), sight.voxel(), kMostPlaces);
  for (int round = 0; round < kMostRounds && !lines.empty(); ++round) {
    for (const CrackLine& line : lines) claims.claims.push_back(line.claim);
    claims.sortAndUnite();
    const std::vector<Sighted> found = varyLines(sight, lines, round);
    lines = newLines(cracksOf(found), claims);  // before these claims are known
    addClaims(found, claims);
  }
}

}  // namespace enfilade
