#pragma once

#include <array>
#include <string>

#include "scene/building.h"

namespace enfilade {

/// Which of the small programs draws a material: there are no branches on it in the shaders.
struct ProgramVariant {
  bool textured = false;
  bool double_sided = false;
  AlphaMode alpha_mode = AlphaMode::kOpaque;

  std::size_t index() const noexcept {
    return (textured ? 1u : 0u) + (double_sided ? 2u : 0u) +
           4u * static_cast<std::size_t>(alpha_mode);
  }
  bool operator==(const ProgramVariant& other) const = default;
};
inline constexpr std::size_t kProgramVariants = 12;

/// The attributes of the programs, in order: those of WorldVertex.
inline constexpr std::array<const char*, 4> kVertexAttributes = {"position", "front", "back",
                                                                 "texcoord"};

/// Uniforms: mat4 clip_from_world; sampler2D image; float cutoff (where they apply).
std::string vertexShader(const ProgramVariant& variant);
std::string fragmentShader(const ProgramVariant& variant);

/// Programs of a polygon (attributes position and texcoord): coloured by the fragment's own place
/// in the sampler2D `image`, passing where its alpha is 0; by texture coordinates; and by the float
/// `mark` alone, in alpha.
inline constexpr std::array<const char*, 2> kPolygonAttributes = {"position", "texcoord"};
extern const char* const kPolygonVertexShader;
extern const char* const kScreenPolygonFragmentShader;
extern const char* const kTexturedPolygonFragmentShader;
extern const char* const kMarkFragmentShader;

}  // namespace enfilade
