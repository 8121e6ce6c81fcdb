#include "render/frame_buffer.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/error.h"

namespace enfilade {

FrameBuffer::FrameBuffer(const GlFunctions& gl) : gl_(gl) {
  gl_.GenFramebuffers(1, &name_);
  gl_.GenRenderbuffers(1, &color_);
  gl_.GenRenderbuffers(1, &depth_);
}

FrameBuffer::~FrameBuffer() {
  gl_.DeleteFramebuffers(1, &name_);
  gl_.DeleteRenderbuffers(1, &color_);
  gl_.DeleteRenderbuffers(1, &depth_);
}

void FrameBuffer::bind(int width, int height) {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, name_);
  if (width == width_ && height == height_) return;
  GLint renderbuffer = 0;
  GLint viewport[2] = {0, 0};
  gl_.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  gl_.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const int most = std::min({renderbuffer, viewport[0], viewport[1]});
  if (width < 1 || height < 1 || width > most || height > most) {
    throw Error(ErrorKind::kMachine, "OpenGL",
                fmt::format("cannot draw a picture of {} x {} pixels; at most {} x {}", width,
                            height, most, most));
  }
  const auto attach = [&](GLuint buffer, GLenum format, GLenum attachment) {
    gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  };
  width_ = height_ = 0;
  attach(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  attach(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
  if (gl_.GetError() != GL_NO_ERROR ||
      gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(ErrorKind::kMachine, "OpenGL",
                fmt::format("has no memory for a picture of {} x {} pixels", width, height));
  }
  width_ = width;
  height_ = height;
}

}  // namespace enfilade
