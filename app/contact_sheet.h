#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "app/frame_painter.h"
#include "app/walk.h"

namespace enfilade {

/// Pictures side by side for a person to compare: a row a frame; in it geometry, each method with
/// portal images, and how the last of these differs from geometry.
struct ContactSheet {
  struct Row {
    std::size_t frame = 0;
    std::vector<double> psnr_db;  ///< of each method against geometry; the first is geometry
  };
  std::vector<Method> methods;  ///< the columns but the last, which is the difference
  std::vector<Row> rows;
  glm::ivec2 cell{0};  ///< size of one picture [pixels]; kSheetGap between them, none around
  Image picture;
};

inline constexpr int kSheetGap = 8;              ///< [pixels]
inline constexpr int kSheetAmplification = 4;    ///< of the differences shown
inline constexpr int kSheetGreatestCell = 1280;  ///< [pixels] larger frames are shrunk to fit

/// The `count` indices with the least values, ascending by value, no two nearer than `apart` to
/// each other: neighbours in a walk show the same.
std::vector<std::size_t> worstFrames(std::span<const double> values, std::size_t count,
                                     std::size_t apart);

/// Pictures of one size in rows and columns, kSheetGap of white between them, none around.
Image arranged(const std::vector<std::vector<Image>>& rows);

/// |a − b| · `times`, at most 255, opaque.
Image amplifiedDifference(const Image& a, const Image& b, int times);

/// The means of squares of `by` × `by` pixels; what is left over on the right and below is cut off.
Image shrunk(const Image& image, int by);

/// Paints `frames` of the walk by geometry and `methods`.
ContactSheet makeContactSheet(FramePainter& painter, const Walk& walk,
                              std::span<const Method> methods, std::span<const std::size_t> frames);

}  // namespace enfilade
