#include "app/playback.h"

#include <fmt/format.h>

#include "scene/file_io.h"

namespace enfilade {

namespace {

Camera at(const Camera& camera, const TimedPose& timed) {
  Camera placed = camera;
  placed.pose = timed.pose;
  return placed;
}

void report(const ProgressSink& progress, const std::string& stage, std::size_t done,
            std::size_t total) {
  if (progress) progress(stage, static_cast<double>(done) / static_cast<double>(total));
}

/// The timed pass of one method.
void timeFrames(FramePainter& painter, Method method, const CameraPath& path, const Camera& camera,
                int warm_up, const ProgressSink& progress, std::vector<FrameRecord>& records) {
  const std::string stage = std::string("playing by ") + infoOf(method).name;
  const std::size_t frames = path.poses.size();
  report(progress, stage, 0, frames);
  painter.prepare(method);
  for (int i = 0; i < warm_up; ++i) painter.paint(method, at(camera, path.poses.front()));
  for (std::size_t frame = 0; frame < frames; ++frame) {
    records.push_back({method, frame, painter.paint(method, at(camera, path.poses[frame])), {}});
    report(progress, stage, frame + 1, frames);
  }
}

/// The pass that looks at pictures: the record of method m and frame f is records[m · frames + f].
void lookAtFrames(FramePainter& painter, const CameraPath& path, const Camera& camera,
                  const PlaybackParameters& parameters, const ProgressSink& progress,
                  std::vector<FrameRecord>& records) {
  const std::string stage = parameters.quality ? "comparing pictures" : "keeping pictures";
  const std::size_t frames = path.poses.size();
  Image truth, picture;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    report(progress, stage, frame, frames);
    const Camera placed = at(camera, path.poses[frame]);
    if (parameters.quality) {
      painter.paint(Method::kGeometry, placed);
      painter.read(truth);
    }
    for (std::size_t m = 0; m < parameters.methods.size(); ++m) {
      const Method method = parameters.methods[m];
      painter.paint(method, placed);
      painter.read(picture);
      if (parameters.quality) records[m * frames + frame].quality = compareImages(picture, truth);
      if (!parameters.frames_dir.empty()) {
        writePng(parameters.frames_dir + "/" + frameFile(method, frame), picture);
      }
    }
  }
  report(progress, stage, frames, frames);
}

}  // namespace

std::string frameFile(Method method, std::size_t frame) {
  return fmt::format("{}/frame-{:05}.png", infoOf(method).name, frame);
}

std::vector<FrameRecord> playBack(FramePainter& painter, const CameraPath& path,
                                  const Camera& camera, const PlaybackParameters& parameters,
                                  const ProgressSink& progress) {
  // Before the long work, so that a folder that cannot be written is known at once.
  if (!parameters.frames_dir.empty()) {
    for (const Method method : parameters.methods) {
      createFolders(parameters.frames_dir + "/" + infoOf(method).name);
    }
  }
  std::vector<FrameRecord> records;
  records.reserve(parameters.methods.size() * path.poses.size());
  for (const Method method : parameters.methods) {
    timeFrames(painter, method, path, camera, parameters.warm_up, progress, records);
  }
  if (parameters.quality || !parameters.frames_dir.empty()) {
    lookAtFrames(painter, path, camera, parameters, progress, records);
  }
  return records;
}

}  // namespace enfilade
