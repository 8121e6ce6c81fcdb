#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ibr/image_kinds.h"

namespace enfilade {

/// How a frame is made.
enum class Method : std::uint8_t { kGeometry, kRaycast, kCulling, kTexture, kWarp, kWarp2, kLdi };

struct MethodInfo {
  Method method;
  const char* name;                        ///< on the command line and in reports
  const char* description;                 ///< what a portal shows
  bool by_cells;                           ///< only the cells that can be seen are drawn
  bool portal_images;                      ///< portals beyond the switch distance show images
  ImageKind image_kind = ImageKind::kLdi;  ///< of which kind they are
  int images_at_once = 1;                  ///< how many of them a portal shows, one over another
};

/// The kinds of images that `methods` show.
ImageKinds imageKindsOf(std::span<const Method> methods);

/// Every method there is, in the order of Method.
std::span<const MethodInfo> allMethods();

const MethodInfo& infoOf(Method method);

/// The names of all methods, joined by ", ".
std::string methodNames();

/// The methods named in `list`, joined by commas, in that order.  Throws Error (kUsage) for a name
/// that is none, saying which there are, and for one named twice.
std::vector<Method> parseMethods(const std::string& list);

}  // namespace enfilade
