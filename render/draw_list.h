#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_functions.h"

namespace enfilade {

/// Ranges of one index buffer that are drawn under one state, in order; adjacent ranges become one.
class DrawList {
 public:
  void add(std::size_t first, std::uint32_t count) {
    if (count == 0) return;
    if (!counts_.empty() && end_ == first && counts_.back() <= kMost - static_cast<int>(count)) {
      counts_.back() += static_cast<GLsizei>(count);
    } else {
      counts_.push_back(static_cast<GLsizei>(count));
      offsets_.push_back(reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));  // NOLINT
    }
    end_ = first + count;
  }

  bool empty() const noexcept { return counts_.empty(); }

  /// Draws what was added as triangles and forgets it.
  void draw(const GlFunctions& gl) {
    if (counts_.size() == 1) {
      gl.DrawElements(GL_TRIANGLES, counts_[0], GL_UNSIGNED_INT, offsets_[0]);
    } else if (!counts_.empty()) {
      gl.MultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, offsets_.data(),
                           static_cast<GLsizei>(counts_.size()));
    }
    counts_.clear();
    offsets_.clear();
  }

 private:
  static constexpr int kMost = 1 << 30;
  std::vector<GLsizei> counts_;
  std::vector<const void*> offsets_;  // bytes into the index buffer
  std::size_t end_ = 0;               // [indices] of the last range
};

}  // namespace enfilade
