#include "app/quality_pass.h"

#include <algorithm>

#include "app/flicker.h"
#include "app/frame_files.h"

namespace enfilade {

namespace {

constexpr std::size_t kSheetRows = 4;
constexpr std::size_t kSheetSpacing = 20;  ///< the sheet's frames are a 20th of the walk apart

/// What is kept of a method's frame for the next one.
struct LastFrame {
  PictureError error;
  std::vector<SeenPortal> seen;
};

/// Compares frames with the true ones, in the order of the walk.
class Comparison {
 public:
  Comparison(FramePainter& painter, const Walk& walk, std::size_t methods)
      : painter_(painter), walk_(walk), last_(methods), jumps_(methods) {}

  /// Paints the true frame: the painter holds it then.
  const Image& startFrame(std::size_t frame) {
    frame_ = frame;
    std::swap(before_, now_);
    now_.camera = at(frame);
    painter_.paint(Method::kGeometry, now_.camera);
    painter_.read(truth_);
    painter_.readDepth(now_.depth);
    if (frame > 0) motion_ = motionBetween(before_, now_, painter_.width(), painter_.height());
    return truth_;
  }

  /// Compares `picture`, which the painter holds too, and fills in its record.
  void compare(std::size_t m, const Image& picture, FrameRecord& record) {
    painter_.readPortalMask(mask_);
    record.quality = compareImages(picture, truth_, mask_.of_pixel);
    if (record.cost.samples) record.cost.uncovered_percent = painter_.uncoveredPercent(mask_);
    errorOf(picture, truth_, error_);
    if (frame_ > 0) record.flicker = flicker(motion_, error_, last_[m].error);
    std::swap(last_[m].error, error_);
    const std::vector<SeenPortal> seen = painter_.seenPortals();
    if (frame_ > 0) measureJumps(m, record.method, switchesBetween(last_[m].seen, seen));
    last_[m].seen = seen;
  }

  /// All jumps, method after method.
  std::vector<SwitchJump> jumps() const {
    std::vector<SwitchJump> all;
    for (const auto& of_method : jumps_) all.insert(all.end(), of_method.begin(), of_method.end());
    return all;
  }

  Camera at(std::size_t frame) const { return walk_.stepTo(frame, painter_); }

 private:
  void measureJumps(std::size_t m, Method method, const std::vector<PortalSwitch>& switches) {
    for (const PortalSwitch& event : switches) {
      const std::size_t with_image = event.to_geometry ? frame_ - 1 : frame_;
      std::optional<SwitchJump> jump = measureJump(painter_, method, at(with_image), event);
      if (!jump) continue;
      jump->frame = with_image;
      jumps_[m].push_back(*jump);
    }
  }

  FramePainter& painter_;
  const Walk& walk_;
  std::vector<LastFrame> last_;                 ///< one a method
  std::vector<std::vector<SwitchJump>> jumps_;  ///< one a method
  std::size_t frame_ = 0;
  Image truth_;
  DepthView before_, now_;
  FrameMotion motion_;
  PortalMask mask_;
  PictureError error_;
};

std::vector<Method> imageMethodsOf(const std::vector<Method>& methods) {
  std::vector<Method> with_images;
  std::copy_if(methods.begin(), methods.end(), std::back_inserter(with_images),
               [](Method method) { return infoOf(method).portal_images; });
  return with_images;
}

/// The frames at which `method`, the m-th, is worst.
std::vector<std::size_t> worstFramesOf(std::size_t m, std::size_t frames,
                                       const std::vector<FrameRecord>& records) {
  std::vector<double> psnr_db;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    psnr_db.push_back(records[m * frames + frame].quality->psnr_db);
  }
  return worstFrames(psnr_db, kSheetRows, frames / kSheetSpacing + 1);
}

std::optional<ContactSheet> sheetOf(FramePainter& painter, const Walk& walk,
                                    const std::vector<Method>& methods,
                                    const std::vector<FrameRecord>& records) {
  const std::vector<Method> columns = imageMethodsOf(methods);
  if (columns.empty()) return std::nullopt;
  const auto last = std::find(methods.begin(), methods.end(), columns.back());
  const auto m = static_cast<std::size_t>(last - methods.begin());
  const std::vector<std::size_t> frames = worstFramesOf(m, walk.frames(), records);
  return makeContactSheet(painter, walk, columns, frames);
}

}  // namespace

PictureFindings lookAtFrames(FramePainter& painter, const Walk& walk, const PicturePass& pass,
                             const ProgressSink& progress, std::vector<FrameRecord>& records) {
  const std::string stage = pass.quality ? "comparing pictures" : "keeping pictures";
  const std::size_t frames = walk.frames();
  const auto report = [&](std::size_t done) {
    if (progress) progress(stage, static_cast<double>(done) / static_cast<double>(frames));
  };
  painter.repeatFrames();
  Comparison comparison(painter, walk, pass.methods.size());
  Image picture;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    if (!pass.everyFrame() && !pass.keeper.keeps(frame)) continue;
    report(frame);
    if (pass.quality) comparison.startFrame(frame);
    for (std::size_t m = 0; m < pass.methods.size(); ++m) {
      const Method method = pass.methods[m];
      painter.paint(method, comparison.at(frame));
      painter.read(picture);
      if (!pass.frames_dir.empty()) {
        writePng(pass.frames_dir + "/" + frameFile(method, frame), picture);
      }
      if (pass.keeper.keeps(frame)) pass.keeper.keep(method, frame, picture);
      if (pass.quality) comparison.compare(m, picture, records[m * frames + frame]);
    }
  }
  PictureFindings findings;
  if (pass.quality) {
    findings.jumps = comparison.jumps();
    findings.sheet = sheetOf(painter, walk, pass.methods, records);
  }
  report(frames);
  return findings;
}

}  // namespace enfilade
