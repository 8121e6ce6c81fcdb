#include "models/patterns.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

const std::vector<PatternKind>& allPatterns() {
  static const std::vector<PatternKind> patterns = [] {
    std::vector<PatternKind> all{{"plain", 0, 0, nullptr}};
    for (const auto& some : {materialPatterns(), wallPatterns(), picturePatterns()})
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }();
  return patterns;
}

std::uint8_t toByte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

}  // namespace

bool isPattern(const std::string& name) {
  return std::any_of(allPatterns().begin(), allPatterns().end(),
                     [&](const PatternKind& kind) { return name == kind.name; });
}

std::vector<std::string> patternNames() {
  std::vector<std::string> names;
  for (const PatternKind& kind : allPatterns()) names.emplace_back(kind.name);
  return names;
}

const glm::dvec3& colorOf(const PlanFinish& finish, std::size_t i) {
  return finish.colors[std::min(i, finish.colors.size() - 1)];
}

Image paintPattern(const PlanFinish& finish) {
  const auto kind = std::find_if(allPatterns().begin(), allPatterns().end(),
                                 [&](const PatternKind& k) { return finish.pattern == k.name; });
  Image image{kind->width, kind->height, {}};
  image.rgba.reserve(std::size_t{4} * static_cast<std::size_t>(kind->width * kind->height));
  const glm::dvec2 pixel(1.0 / kind->width, 1.0 / kind->height);
  for (int y = 0; y < kind->height; ++y) {
    for (int x = 0; x < kind->width; ++x) {
      const glm::dvec3 color = kind->paint(finish, (glm::dvec2(x, y) + 0.5) * pixel);
      for (int c = 0; c < 3; ++c) image.rgba.push_back(toByte(color[c]));
      image.rgba.push_back(255);
    }
  }
  return image;
}

}  // namespace enfilade
