#include "tests/bench/warp_peers.h"

#include <memory>

#ifdef ENFILADE_OPENCV
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/rgbd.hpp>
#endif
#ifdef ENFILADE_OPEN3D
#include <open3d/t/geometry/PointCloud.h>
#include <open3d/t/geometry/RGBDImage.h>
#endif

namespace enfilade::bench {
namespace {

/// Focal lengths and principal point of a camera with square pixels.
struct Pinhole {
  double focal_x, focal_y, center_x, center_y;
};

Pinhole pinholeOf(const PlanarCamera& camera) {
  const double near = imagePlaneDistance(camera);
  const glm::dmat3& p = camera.world_from_pixel;
  return {near / glm::length(p[0]), near / glm::length(p[1]),
          -glm::dot(p[2], p[0]) / glm::dot(p[0], p[0]),
          -glm::dot(p[2], p[1]) / glm::dot(p[1], p[1])};
}

/// Right, down, ahead.
glm::dmat3 axesOf(const PlanarCamera& camera) {
  const glm::dmat3& p = camera.world_from_pixel;
  return {glm::normalize(p[0]), glm::normalize(p[1]), glm::normalize(glm::cross(p[0], p[1]))};
}

float depthAt(const PeerScene& scene, std::size_t pixel) {
  return static_cast<float>(imagePlaneDistance(scene.image.camera)) / scene.image.disparity[pixel];
}

#ifdef ENFILADE_OPENCV
std::function<void()> prepareOpenCv(const PeerScene& scene) {
  const PlanarCamera& from = scene.image.camera;
  const cv::Mat color(from.height, from.width, CV_8UC4,
                      const_cast<std::uint8_t*>(scene.image.color.rgba.data()));  // NOLINT
  cv::Mat rgb, depth(from.height, from.width, CV_32F);
  cv::cvtColor(color, rgb, cv::COLOR_RGBA2BGR);
  for (std::size_t p = 0; p < scene.image.disparity.size(); ++p) {
    depth.ptr<float>()[p] = depthAt(scene, p);
  }
  const Pinhole k = pinholeOf(from);
  const cv::Mat camera =
      (cv::Mat_<double>(3, 3) << k.focal_x, 0, k.center_x, 0, k.focal_y, k.center_y, 0, 0, 1);
  const glm::dmat3 to_axes = axesOf(scene.desired);
  const glm::dmat3 rotation = glm::transpose(to_axes) * axesOf(from);
  const glm::dvec3 offset = glm::transpose(to_axes) * (from.center - scene.desired.center);
  cv::Mat pose = cv::Mat::eye(4, 4, CV_64F);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.at<double>(row, column) = rotation[column][row];
    pose.at<double>(row, 3) = offset[row];
  }
  return [=] {
    cv::Mat warped;
    cv::rgbd::warpFrame(rgb, depth, cv::Mat(), pose, camera, cv::Mat(), warped);
  };
}
#endif

#ifdef ENFILADE_OPEN3D
std::function<void()> prepareOpen3d(const PeerScene& scene) {
  using open3d::core::Tensor;
  const PlanarCamera& from = scene.image.camera;
  const auto count = static_cast<std::int64_t>(scene.image.disparity.size());
  std::vector<float> points, colors;
  const glm::dmat3 to_axes = glm::transpose(axesOf(scene.desired));
  for (std::size_t p = 0; p < scene.image.disparity.size(); ++p) {
    const auto width = static_cast<std::size_t>(from.width);
    const glm::dvec3 place(static_cast<double>(p % width) + 0.5,
                           static_cast<double>(p / width) + 0.5,
                           static_cast<double>(scene.image.disparity[p]));
    const glm::dvec3 at = to_axes * (unprojectPoint(from, place) - scene.desired.center);
    for (int c = 0; c < 3; ++c) points.push_back(static_cast<float>(at[c]));
    for (std::size_t c = 0; c < 3; ++c) {
      colors.push_back(static_cast<float>(scene.image.color.rgba[4 * p + c]) / 255.0f);
    }
  }
  auto cloud = std::make_shared<open3d::t::geometry::PointCloud>(
      Tensor(points, {count, 3}, open3d::core::Float32));
  cloud->SetPointColors(Tensor(colors, {count, 3}, open3d::core::Float32));
  const Pinhole k = pinholeOf(scene.desired);
  const Tensor camera(
      std::vector<double>{k.focal_x, 0, k.center_x, 0, k.focal_y, k.center_y, 0, 0, 1}, {3, 3},
      open3d::core::Float64);
  const int width = from.width;
  const int height = from.height;
  return [=] {
    cloud->ProjectToRGBDImage(width, height, camera,
                              Tensor::Eye(4, open3d::core::Float64, open3d::core::Device("CPU:0")),
                              1.0f, 1000.0f);
  };
}
#endif

}  // namespace

std::vector<Peer> foundPeers() {
  std::vector<Peer> peers;
#ifdef ENFILADE_OPENCV
  cv::setNumThreads(1);
  peers.push_back({"OpenCV rgbd::warpFrame", prepareOpenCv});
#endif
#ifdef ENFILADE_OPEN3D
  peers.push_back({"Open3D ProjectToRGBDImage", prepareOpen3d});
#endif
  return peers;
}

}  // namespace enfilade::bench
