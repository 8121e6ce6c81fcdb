#pragma once

#include "render/gl_functions.h"

namespace enfilade {

/// A framebuffer object with RGBA8 colour and 32-bit float depth.  The context must be current.
class FrameBuffer {
 public:
  explicit FrameBuffer(const GlFunctions& gl);
  ~FrameBuffer();
  FrameBuffer(const FrameBuffer&) = delete;
  FrameBuffer& operator=(const FrameBuffer&) = delete;

  /// Binds it, with this size.  Throws Error (kMachine) if the size is not positive, or more than
  /// the machine can.
  void bind(int width, int height);

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }

 private:
  const GlFunctions& gl_;
  int width_ = 0;
  int height_ = 0;
  GLuint name_ = 0;
  GLuint color_ = 0;
  GLuint depth_ = 0;
};

}  // namespace enfilade
