#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// How a list of corners makes triangles.
enum class Topology : std::uint8_t { kTriangles, kStrip, kFan };

/// Three indices a triangle, wound as glTF says; corners left over at the end are dropped.
/// Source: Khronos, glTF 2.0 specification, section 3.7.2.1.
std::vector<std::uint32_t> toTriangles(std::vector<std::uint32_t> corners, Topology topology);

/// Vertices of its own for every corner of `triangles`, with the normal of its triangle (+Y where
/// the triangle has no area); `triangles` becomes 0, 1, 2, ….  Normals that were there are lost.
VertexArrays unshareFlat(const VertexArrays& vertices, std::vector<std::uint32_t>& triangles);

/// Takes out the triangles that have a corner which is not finite.  Returns how many.
std::size_t dropNonFinite(const VertexArrays& vertices, std::vector<std::uint32_t>& triangles);

}  // namespace enfilade
