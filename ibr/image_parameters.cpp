#include "ibr/image_parameters.h"

#include <fmt/format.h>

#include <charconv>

#include "scene/error.h"

namespace enfilade {
namespace {

using Texts = std::map<std::string, std::string>;

/// Calls field(name, value, least, most) for every number.
template <class Parameters, class Field>
void forEachNumber(Parameters& p, Field&& field) {
  field("image_size_px", p.image_size, 16, 4096);
  field("captures", p.captures, 1, 180);
  field("capture_angle_deg", p.capture_angle, 0.0f, 85.0f);
  field("rays", p.rays, 1, 4);
  field("textures_per_portal", p.textures, 1, 180);
  field("images_per_portal", p.references, 1, 180);
  field("switch_distance_m", p.switch_distance, 0.01f, 1e4f);
  field("portal_margin_m", p.portal_margin, 0.0f, 1.0f);
  field("ldi_half_width", p.ldi_half_width, 1.0f, 1e3f);
  field("depth_threshold_px", p.depth_threshold, 0.0f, 1e3f);
}

constexpr const char* kRingsName = "more_rings";
constexpr std::size_t kMostRings = 16;

[[noreturn]] void reject(const std::string& file, const std::string& name,
                         const std::string& text) {
  throw Error(ErrorKind::kBadInput, file,
              fmt::format("its parameter {} is '{}', which cannot be", name, text));
}

/// Reads a number off the front of `text`; false if there is none from `least` to `most`.
template <class Number>
bool take(std::string_view& text, Number& value, Number least, Number most) {
  const char* const end = text.data() + text.size();
  const auto [beyond, error] = std::from_chars(text.data(), end, value);
  text.remove_prefix(static_cast<std::size_t>(beyond - text.data()));
  return error == std::errc() && value >= least && value <= most;
}

bool take(std::string_view& text, char expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(1);
  return true;
}

/// "6@62.5deg-0.5m": captures, angle, and height above the eye; rings are joined by commas.
std::string ringsText(const std::vector<CaptureRing>& rings) {
  std::string text;
  for (const CaptureRing& ring : rings) {
    text += fmt::format("{}{}@{}deg{:+}m", text.empty() ? "" : ",", ring.captures,
                        ring.capture_angle, ring.above_eye);
  }
  return text;
}

bool takeRings(std::string_view text, std::vector<CaptureRing>& rings) {
  rings.clear();
  while (!text.empty()) {
    CaptureRing ring;
    if (!rings.empty() && !take(text, ',')) return false;
    if (!take(text, ring.captures, 0, 180) || !take(text, '@')) return false;
    if (!take(text, ring.capture_angle, 0.0f, 85.0f)) return false;
    if (!text.starts_with("deg")) return false;
    text.remove_prefix(3);
    if (text.starts_with('+')) text.remove_prefix(1);  // from_chars takes no plus sign
    if (!take(text, ring.above_eye, -10.0f, 10.0f) || !take(text, 'm')) return false;
    if (rings.size() == kMostRings) return false;
    rings.push_back(ring);
  }
  return true;
}

}  // namespace

Texts imageParameterTexts(const ImageParameters& parameters) {
  Texts texts;
  forEachNumber(parameters, [&](const char* name, auto value, auto, auto) {
    texts[name] = fmt::format("{}", value);
  });
  texts["bake"] = imageKindNames(parameters.bake);
  texts[kRingsName] = ringsText(parameters.more_rings);
  return texts;
}

ImageParameters imageParametersFrom(const Texts& texts, const std::string& file) {
  ImageParameters parameters;
  forEachNumber(parameters, [&](const char* name, auto& value, auto least, auto most) {
    const auto entry = texts.find(name);
    if (entry == texts.end()) return;
    std::string_view text = entry->second;
    if (!take(text, value, least, most) || !text.empty()) reject(file, name, entry->second);
  });
  if (const auto rings = texts.find(kRingsName); rings != texts.end()) {
    if (!takeRings(rings->second, parameters.more_rings)) reject(file, kRingsName, rings->second);
  }
  return parameters;
}

}  // namespace enfilade
