#include "models/profile_curve.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

constexpr int kSamplesPerSegment = 24;

}  // namespace

ProfileCurve::ProfileCurve(std::vector<glm::dvec2> points) : points_(std::move(points)) {
  for (std::size_t i = 0; i + 1 < points_.size(); ++i)
    for (int k = 0; k < kSamplesPerSegment; ++k)
      samples_.push_back(spline(i, double(k) / kSamplesPerSegment));
  samples_.push_back(points_.back());
  lengths_.push_back(0);
  for (std::size_t i = 1; i < samples_.size(); ++i)
    lengths_.push_back(lengths_.back() + glm::distance(samples_[i - 1], samples_[i]));
}

glm::dvec2 ProfileCurve::spline(std::size_t segment, double t) const {
  const glm::dvec2 b = points_[segment], c = points_[segment + 1];
  if (b == c) return b;
  // Next to a doubled point the tangent is that of the segment itself.
  const glm::dvec2 before = segment > 0 ? points_[segment - 1] : b;
  const glm::dvec2 after = segment + 2 < points_.size() ? points_[segment + 2] : c;
  const glm::dvec2 m0 = before == b ? c - b : 0.5 * (c - before);
  const glm::dvec2 m1 = after == c ? c - b : 0.5 * (after - b);
  const double t2 = t * t, t3 = t2 * t;
  glm::dvec2 p =
      (2 * t3 - 3 * t2 + 1) * b + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * c + (t3 - t2) * m1;
  p.x = std::max(p.x, 0.0);
  return p;
}

glm::dvec2 ProfileCurve::at(double t) const {
  const double along = std::clamp(t, 0.0, 1.0) * lengths_.back();
  const auto next = std::upper_bound(lengths_.begin(), lengths_.end() - 1, along);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - lengths_.begin(), 1));
  const double span = lengths_[i] - lengths_[i - 1];
  const double part = span > 0 ? (along - lengths_[i - 1]) / span : 0;
  return glm::mix(samples_[i - 1], samples_[i], part);
}

}  // namespace enfilade
