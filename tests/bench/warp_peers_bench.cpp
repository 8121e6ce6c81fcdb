// One image of 640 × 512 pixels warped into a view beside it: by us, as llvmpipe's points, and by
// the libraries that were found (OpenCV's rgbd::warpFrame, Open3D's ProjectToRGBDImage).  Each
// "a sample" is the time for one pixel of the image.

#include <benchmark/benchmark.h>

#include "ibr/ldi_builder.h"
#include "ibr/warp.h"
#include "render/gl_context.h"
#include "render/gl_program.h"
#include "render/thread_team.h"
#include "tests/bench/warp_peers.h"

namespace enfilade::bench {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 512;

PlanarCamera eyeAt(double x) {
  return testing::desiredCamera({x, 1.6, -0.3}, {0.2, 1.2, -4}, kWidth, kHeight);
}

const PeerScene& scene() {
  static const PeerScene made = [] {
    PeerScene s;
    s.image = testing::castImage(testing::furnishedRoom(), eyeAt(0.0));
    s.desired = eyeAt(0.25);
    return s;
  }();
  return made;
}

void countSamples(benchmark::State& state) {
  state.counters["a sample"] =
      benchmark::Counter(double{kWidth} * kHeight, benchmark::Counter::kIsIterationInvariantRate |
                                                       benchmark::Counter::kInvert);
}

void ours(benchmark::State& state, Splat splat, int threads) {
  ThreadTeam team(threads);
  LdiBuilder builder(scene().image.camera, {});
  builder.insert(resolveCapture(scene().image, 1, 0.0f));
  const Ldi ldi = builder.finish();
  WarpBuffer buffer;
  buffer.resize(kWidth, kHeight);
  const std::vector<glm::vec2> all = testing::wholePicture(scene().desired);
  for (auto _ : state) {
    warpLdi(ldi, scene().desired, all, buffer, {splat, Clip::kTiles, &team});
  }
  countSamples(state);
}

constexpr const char* kPointVertex = R"(#version 330 core
uniform mat4 clip_from_world;
uniform float size;
in vec3 position;
in vec4 color;
out vec4 v_color;
void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  gl_PointSize = size;
  v_color = color;
})";
constexpr const char* kPointFragment = R"(#version 330 core
in vec4 v_color;
out vec4 pixel;
void main() { pixel = v_color; })";
constexpr const char* kPointAttributes[] = {"position", "color"};

struct PointVertex {
  glm::vec3 position;
  std::uint8_t rgba[4];
};

std::vector<PointVertex> pointsOf(const DepthImage& image) {
  std::vector<PointVertex> points;
  for (std::size_t p = 0; p < image.disparity.size(); ++p) {
    const glm::dvec3 place(double(p % kWidth) + 0.5, double(p / kWidth) + 0.5,
                           double(image.disparity[p]));
    PointVertex v{glm::vec3(unprojectPoint(image.camera, place)), {}};
    std::copy_n(&image.color.rgba[4 * p], 4, v.rgba);
    points.push_back(v);
  }
  return points;
}

/// The default framebuffer of the context may be tiny: draw into one of our own.
void bindFrame(const GlFunctions& gl) {
  GLuint frame = 0, buffers[2];
  gl.GenFramebuffers(1, &frame);
  gl.GenRenderbuffers(2, buffers);
  gl.BindFramebuffer(GL_FRAMEBUFFER, frame);
  const GLenum formats[2] = {GL_RGBA8, GL_DEPTH_COMPONENT32F};
  const GLenum places[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, formats[i], kWidth, kHeight);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffers[i]);
  }
  gl.Viewport(0, 0, kWidth, kHeight);
}

void llvmpipePoints(benchmark::State& state, float size) {
  const auto context = createOsMesaContext(2);
  const GlFunctions& gl = context->gl();
  bindFrame(gl);
  const std::vector<PointVertex> points = pointsOf(scene().image);
  GLuint array = 0, buffer = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(PointVertex)),
                points.data(), GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(0);
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(PointVertex), nullptr);
  gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(PointVertex),
                         reinterpret_cast<const void*>(sizeof(glm::vec3)));  // NOLINT
  const GLuint program = createProgram(gl, kPointVertex, kPointFragment, kPointAttributes);
  gl.UseProgram(program);
  const glm::mat4 clip = viewOf(scene().desired, 100.0).clip_from_world;
  gl.UniformMatrix4fv(gl.GetUniformLocation(program, "clip_from_world"), 1, GL_FALSE, &clip[0][0]);
  gl.Uniform1f(gl.GetUniformLocation(program, "size"), size);
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  gl.Enable(GL_DEPTH_TEST);
  for (auto _ : state) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points.size()));
    gl.Finish();
  }
  countSamples(state);
}

template <class Run>
void add(const std::string& name, Run run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMillisecond);
}

void addAll() {
  for (const int threads : {1, 2}) {
    for (const SplatInfo& info : allSplats()) {
      const Splat splat = info.splat;
      add("enfilade/" + std::string(info.name) + "/threads:" + std::to_string(threads),
          [splat, threads](benchmark::State& s) { ours(s, splat, threads); });
    }
  }
  add("llvmpipe points/1x1/threads:2", [](benchmark::State& s) { llvmpipePoints(s, 1.0f); });
  add("llvmpipe points/2x2/threads:2", [](benchmark::State& s) { llvmpipePoints(s, 2.0f); });
  for (const Peer& peer : foundPeers()) {
    add(peer.name, [peer](benchmark::State& s) {
      const auto warp = peer.prepare(scene());
      for (auto _ : s) warp();
      countSamples(s);
    });
  }
}

}  // namespace
}  // namespace enfilade::bench

int main(int argc, char** argv) {
  enfilade::bench::addAll();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
