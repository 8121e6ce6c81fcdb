#include "app/playback.h"

#include "app/frame_files.h"
#include "scene/file_io.h"

namespace enfilade {

namespace {

void report(const ProgressSink& progress, const std::string& stage, std::size_t done,
            std::size_t total) {
  if (progress) progress(stage, static_cast<double>(done) / static_cast<double>(total));
}

/// The timed pass of one method.
void timeFrames(FramePainter& painter, Method method, const Walk& walk, int warm_up,
                const ProgressSink& progress, std::vector<FrameRecord>& records) {
  const std::string stage = std::string("playing by ") + infoOf(method).name;
  const std::size_t frames = walk.frames();
  report(progress, stage, 0, frames);
  painter.prepare(method);
  for (int i = 0; i < warm_up; ++i) painter.paint(method, walk.stepTo(0, painter));
  for (std::size_t frame = 0; frame < frames; ++frame) {
    records.push_back({method, frame, painter.paint(method, walk.stepTo(frame, painter))});
    report(progress, stage, frame + 1, frames);
  }
}

}  // namespace

Playback playBack(FramePainter& painter, const Walk& walk, const PlaybackParameters& parameters,
                  const ProgressSink& progress) {
  // Before the long work, so that a folder that cannot be written is known at once.
  if (!parameters.frames_dir.empty()) {
    for (const Method method : parameters.methods) {
      createFolders(parameters.frames_dir + "/" + infoOf(method).name);
      removeFramesFrom(walk.frames(), parameters.frames_dir, method);
    }
  }
  parameters.keeper.begin(parameters.methods);
  Playback played;
  played.records.reserve(parameters.methods.size() * walk.frames());
  for (const Method method : parameters.methods) {
    timeFrames(painter, method, walk, parameters.warm_up, progress, played.records);
  }
  const PicturePass pass{parameters.methods, parameters.quality, parameters.frames_dir,
                         parameters.keeper, parameters.in_order};
  if (pass.quality || !pass.frames_dir.empty() || pass.keeper.stride() > 0) {
    played.findings = lookAtFrames(painter, walk, pass, progress, played.records);
  }
  return played;
}

}  // namespace enfilade
