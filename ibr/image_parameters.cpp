#include "ibr/image_parameters.h"

#include <fmt/format.h>

#include <charconv>

#include "ibr/capture_plan.h"
#include "scene/error.h"

namespace enfilade {
namespace {

using Texts = std::map<std::string, std::string>;

/// Calls field(name, value, least, most) for every number.
template <class Parameters, class Field>
void forEachNumber(Parameters& p, Field&& field) {
  field("image_size_px", p.image_size, 16, 4096);
  field("rays", p.rays, 1, 4);
  field("textures_per_portal", p.textures, 1, 180);
  field("images_per_portal", p.references, 1, 180);
  field("switch_distance_m", p.switch_distance, 0.01f, 1e4f);
  field("portal_margin_m", p.portal_margin, 0.0f, 1.0f);
  field("ldi_half_width", p.ldi_half_width, 1.0f, 1e3f);
  field("depth_threshold_px", p.depth_threshold, 0.0f, 1e3f);
}

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

/// The plan of captures that `text` tells; a number alone, as houses once had it, is one ring.
std::vector<CaptureRing> ringsFrom(const std::string& file, const std::string& text) {
  const bool number = text.find_first_not_of("0123456789") == std::string::npos;
  try {
    return parseCapturePlan(number ? "ring:" + text : text);
  } catch (const Error&) {
    reject(file, "captures", text);
  }
}

constexpr const char* kRayCast = "raycast";

}  // namespace

Texts imageParameterTexts(const ImageParameters& parameters) {
  Texts texts;
  forEachNumber(parameters, [&](const char* name, auto value, auto, auto) {
    texts[name] = fmt::format("{}", value);
  });
  texts["bake"] = imageKindNames(parameters.bake);
  texts["captures"] = capturePlanText(parameters.rings);
  texts["ldi"] = parameters.ldi == LdiMaking::kRayCast ? kRayCast : "warp";
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
  if (const auto plan = texts.find("captures"); plan != texts.end()) {
    parameters.rings = ringsFrom(file, plan->second);
  }
  const auto making = texts.find("ldi");
  if (making != texts.end() && making->second == kRayCast) parameters.ldi = LdiMaking::kRayCast;
  return parameters;
}

}  // namespace enfilade
