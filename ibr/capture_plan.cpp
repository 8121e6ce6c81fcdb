#include "ibr/capture_plan.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "scene/error.h"

namespace enfilade {
namespace {

constexpr std::string_view kRing = "ring:";
constexpr std::size_t kMostRings = 16;

/// The part of a plan that is being read.
struct Reader {
  const std::string& plan;
  std::string_view ring;  ///< the ring at hand, what was read of it taken off

  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(ErrorKind::kUsage, "--captures " + plan,
                reason +
                    "; write ring:COUNT, with @HEIGHT (m above the eye) and /ANGLE (degrees) if "
                    "you like, several joined by commas, such as ring:13,ring:6@-0.5/62.5");
  }

  template <typename Number>
  Number number(const char* what, const char* unit, Number least, Number most) {
    Number value{};
    const auto [end, error] = std::from_chars(ring.data(), ring.data() + ring.size(), value);
    if (error != std::errc() || !(value >= least && value <= most)) {
      refuse(fmt::format("the {} must be {} to {}{}", what, least, most, unit));
    }
    ring.remove_prefix(static_cast<std::size_t>(end - ring.data()));
    return value;
  }

  bool take(std::string_view start) {
    const bool starts = ring.starts_with(start);
    if (starts) ring.remove_prefix(start.size());
    return starts;
  }
};

CaptureRing parseRing(const std::string& plan, std::string_view text) {
  Reader reader{plan, text};
  if (!reader.take(kRing)) reader.refuse(fmt::format("'{}' is no ring", text));
  CaptureRing ring;
  ring.captures = reader.number("count", "", 1, 180);
  if (reader.take("@")) ring.above_eye = reader.number("height", " m", -3.0f, 3.0f);
  if (reader.take("/")) ring.angle = reader.number("angle", " degrees", 0.0f, 85.0f);
  if (!reader.ring.empty()) {
    reader.refuse(fmt::format("'{}' in '{}' makes no sense", reader.ring, text));
  }
  return ring;
}

}  // namespace

std::vector<CaptureRing> parseCapturePlan(const std::string& text) {
  std::vector<CaptureRing> rings;
  std::size_t first = 0;
  while (first <= text.size()) {
    const std::size_t comma = std::min(text.find(',', first), text.size());
    rings.push_back(parseRing(text, std::string_view(text).substr(first, comma - first)));
    first = comma + 1;
  }
  if (rings.size() > kMostRings) {
    Reader{text, {}}.refuse(
        fmt::format("{} rings are too many; {} at most", rings.size(), kMostRings));
  }
  return rings;
}

std::string capturePlanText(const std::vector<CaptureRing>& rings) {
  const CaptureRing usual;
  std::string text;
  for (const CaptureRing& ring : rings) {
    text += fmt::format("{}{}{}", text.empty() ? "" : ",", kRing, ring.captures);
    if (ring.above_eye != usual.above_eye) text += fmt::format("@{}", ring.above_eye);
    if (ring.angle != usual.angle) text += fmt::format("/{}", ring.angle);
  }
  return text;
}

}  // namespace enfilade
