#include "app/methods.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "scene/error.h"

namespace enfilade {

namespace {

constexpr std::array<MethodInfo, 7> kMethods = {{
    {Method::kGeometry, "geometry", "everything in the view, the ground truth", false, false},
    {Method::kRaycast, "raycast", "everything, by primary rays (Embree)", false, false},
    {Method::kCulling, "culling", "only what can be seen through portals", true, false},
    {Method::kTexture, "texture", "far portals show the nearest of their textures, mapped on them",
     true, true, ImageKind::kTexture},
    {Method::kWarp, "warp", "far portals show the nearest of their reference images, warped", true,
     true, ImageKind::kReference},
    {Method::kWarp2, "warp2", "the same with the two nearest, the farther first", true, true,
     ImageKind::kReference, 2},
    {Method::kLdi, "ldi", "far portals show a layered depth image, warped", true, true,
     ImageKind::kLdi},
}};

}  // namespace

std::span<const MethodInfo> allMethods() { return kMethods; }

const MethodInfo& infoOf(Method method) { return kMethods[static_cast<std::size_t>(method)]; }

ImageKinds imageKindsOf(std::span<const Method> methods) {
  ImageKinds kinds{false, false, false};
  for (const Method method : methods) {
    const MethodInfo& info = infoOf(method);
    if (!info.portal_images) continue;
    kinds.textures |= info.image_kind == ImageKind::kTexture;
    kinds.references |= info.image_kind == ImageKind::kReference;
    kinds.ldis |= info.image_kind == ImageKind::kLdi;
  }
  return kinds;
}

std::string methodNames() {
  std::string names;
  for (const MethodInfo& info : kMethods)
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  return names;
}

std::vector<Method> parseMethods(const std::string& list) {
  std::vector<Method> found;
  std::istringstream stream(list);
  for (std::string name; std::getline(stream, name, ',');) {
    const auto info = std::find_if(kMethods.begin(), kMethods.end(),
                                   [&](const MethodInfo& m) { return name == m.name; });
    if (info == kMethods.end()) {
      throw Error(ErrorKind::kUsage, "'" + name + "'",
                  "no such method; there are: " + methodNames());
    }
    if (std::find(found.begin(), found.end(), info->method) != found.end()) {
      throw Error(ErrorKind::kUsage, "'" + name + "'", "this method is named twice");
    }
    found.push_back(info->method);
  }
  if (found.empty()) {
    throw Error(ErrorKind::kUsage, "--methods", "none named; there are: " + methodNames());
  }
  return found;
}

}  // namespace enfilade
