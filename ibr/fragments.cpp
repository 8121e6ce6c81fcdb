// Rafferty et al., Images for Accelerating Architectural Walkthroughs, 1998, sec. 3.1.
#include "ibr/fragments.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

constexpr int kBins = 64;

/// A pencil of lines through the epipole, each known by where it meets the line `across` the middle
/// of some tiles.
class Pencil {
 public:
  Pencil(const glm::dvec3& epipole, std::span<const TileWeight> tiles) noexcept
      : epipole_(epipole) {
    double weight = 0;
    for (const TileWeight& t : tiles) {
      middle_ += static_cast<double>(t.weight) * glm::dvec2(t.at);
      weight += static_cast<double>(t.weight);
    }
    middle_ /= weight;
    for (const TileWeight& t : tiles) {
      spread_ += static_cast<double>(t.weight) * glm::distance(glm::dvec2(t.at), middle_);
    }
    spread_ = std::max(1.0, spread_ / weight);
    const glm::dvec2 to_middle = epipole.z * middle_ - glm::dvec2(epipole);
    distance_ = glm::length(to_middle);
    along_ = distance_ > 1e-9 ? to_middle / distance_ : glm::dvec2(0, 1);
    across_ = {-along_.y, along_.x};
  }

  /// Where the line of p meets the line across [pixels from the middle], and the side of the
  /// epipole on which p lies.
  struct Place {
    double at;
    bool beyond;  ///< the epipole is between p and the middle
  };
  Place placeOf(const glm::vec2& p) const noexcept {
    const glm::dvec2 off = glm::dvec2(p) - middle_;
    const double ahead = distance_ + epipole_.z * glm::dot(along_, off);
    const double meets = glm::dot(across_, off) * distance_ / (ahead == 0.0 ? 1e-12 : ahead);
    return {meets / (spread_ + std::abs(meets)), ahead < 0.0};
  }

  /// The line through the epipole with Place::at.
  CutLine lineAt(double at) const noexcept {
    const double meets = spread_ * at / std::max(1e-9, 1.0 - std::abs(at));
    const glm::dvec3 l = glm::cross(epipole_, glm::dvec3(middle_ + meets * across_, 1.0));
    const double length = glm::length(glm::dvec2(l));
    if (!(length > 1e-12)) return {across_.x, across_.y, -glm::dot(across_, middle_) - meets};
    return {l.x / length, l.y / length, l.z / length};
  }

 private:
  glm::dvec3 epipole_;
  glm::dvec2 middle_{0}, along_{0}, across_{0};
  double distance_ = 0, spread_ = 0;
};

double valueAt(const CutLine& line, const glm::dvec2& p) noexcept {
  return line.a * p.x + line.b * p.y + line.c;
}

/// The line of the pencil that has about `share` of the weight on one side.
CutLine balancedLine(const Pencil& pencil, std::span<const TileWeight> tiles,
                     double share) noexcept {
  double least = 1e30, greatest = -1e30;
  for (const TileWeight& t : tiles) {
    const Pencil::Place place = pencil.placeOf(t.at);
    if (place.beyond) continue;
    least = std::min(least, place.at);
    greatest = std::max(greatest, place.at);
  }
  if (!(least < greatest)) return pencil.lineAt(0.0);
  // Left of a line lie what comes before it, and what comes after it beyond the epipole.
  std::array<double, kBins> before{}, beyond{};
  double weight = 0, left = 0;
  for (const TileWeight& t : tiles) {
    const Pencil::Place place = pencil.placeOf(t.at);
    const double bin = (place.at - least) / (greatest - least) * kBins;
    const auto i = static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0));
    (place.beyond ? beyond : before)[i] += static_cast<double>(t.weight);
    left += place.beyond ? static_cast<double>(t.weight) : 0.0;
    weight += static_cast<double>(t.weight);
  }
  double best = 2.0;
  int best_bin = kBins / 2;
  for (int i = 0; i < kBins; ++i) {  // the line before bin i + 1
    left += before[static_cast<std::size_t>(i)] - beyond[static_cast<std::size_t>(i)];
    const double off = std::abs(left / weight - share);
    if (off < best) {
      best = off;
      best_bin = i + 1;
    }
  }
  return pencil.lineAt(least + (greatest - least) * best_bin / kBins);
}

struct Cutting {
  glm::dvec3 epipole;
  std::span<Fragment, kMostFragments> out;
  std::size_t made = 0;

  void cut(const Fragment& fragment, std::span<TileWeight> tiles, int wanted) noexcept {
    if (wanted < 2 || tiles.size() < 2 || fragment.count == kMostCuts) {
      out[made++] = fragment;
      return;
    }
    const int first = wanted / 2;
    const CutLine line =
        balancedLine(Pencil(epipole, tiles), tiles, static_cast<double>(first) / wanted);
    const auto middle = std::partition(tiles.begin(), tiles.end(), [&](const TileWeight& t) {
      return valueAt(line, glm::dvec2(t.at)) >= 0.0;
    });
    const auto count = static_cast<std::size_t>(middle - tiles.begin());
    // The side with fewer tiles is that of the smaller share.
    const bool fewer = 2 * count <= tiles.size();
    Fragment side = fragment;
    side.lines[side.count++] = line;
    cut(side, tiles.first(count), fewer ? first : wanted - first);
    side.flipped[side.count - 1] = true;
    cut(side, tiles.subspan(count), fewer ? wanted - first : first);
  }
};

}  // namespace

glm::ivec2 Fragment::columns(int y, glm::ivec2 span) const noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const CutLine& line = lines[i];
    // The line's value grows by a from column to column: from `edge` on it has the sign of a.
    const double first = valueAt(line, {0.5, y + 0.5});
    const double edge = std::ceil(-first / line.a);
    const bool inside_first = (first >= 0.0) != flipped[i];
    if (!std::isfinite(edge)) {
      if (!inside_first) return {span.x, span.x};
      continue;
    }
    const int column = static_cast<int>(
        std::clamp(edge, double{1} * span.x, std::max(1.0 * span.x, 1.0 * span.y)));
    if ((line.a > 0.0) != flipped[i]) {
      span.x = column;
    } else {
      span.y = column;
    }
  }
  return {span.x, std::max(span.x, span.y)};
}

bool Fragment::mayTouch(const ScreenBox& box) const noexcept {
  constexpr double kBeside = 1.5;  // [pixels]
  for (std::size_t i = 0; i < count; ++i) {
    const CutLine& line = lines[i];
    const double sign = flipped[i] ? -1.0 : 1.0;
    const double a = sign * line.a;
    const double b = sign * line.b;
    const auto x = static_cast<double>(a > 0.0 ? box.right : box.left);
    const auto y = static_cast<double>(b > 0.0 ? box.bottom : box.top);
    if (a * x + b * y + sign * line.c < -kBeside * (std::abs(a) + std::abs(b))) return false;
  }
  return true;
}

std::size_t cutIntoFragments(const glm::dvec3& epipole, std::span<TileWeight> tiles, int wanted,
                             std::span<Fragment, kMostFragments> out) noexcept {
  // A pencil does not depend on the epipole's scale; this keeps it from overflowing.
  const double scale = std::max({std::abs(epipole.x), std::abs(epipole.y), std::abs(epipole.z)});
  Cutting cutting{scale > 0.0 ? epipole / scale : glm::dvec3(0, 1, 0), out};
  cutting.cut({}, tiles, std::min(wanted, static_cast<int>(kMostFragments)));
  return cutting.made;
}

}  // namespace enfilade
