#include "app/film.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/caption.h"
#include "app/ffmpeg_pipe.h"
#include "app/statistics.h"

namespace enfilade {

namespace {

/// A time that can be read although it changes with every frame: the mean of some frames, shown
/// while the next ones are painted.
class SteadyTime {
 public:
  explicit SteadyTime(int frames) : frames_(frames) {}

  double add(double ms) {
    sum_ += ms;
    if (count_++ == 0 && !shown_) shown_ = ms;
    if (count_ == frames_) {
      shown_ = sum_ / count_;
      sum_ = count_ = 0;
    }
    return *shown_;
  }

 private:
  int frames_;
  int count_ = 0;
  double sum_ = 0;
  std::optional<double> shown_;
};

double medianOf(Method method, std::span<const FrameRecord> records) {
  std::vector<double> times;
  for (const FrameRecord& record : records) {
    if (record.method == method) times.push_back(record.cost.frametime_ms);
  }
  return percentile(times, 50);
}

/// Paints the film's frames.
class FilmPainter {
 public:
  FilmPainter(FramePainter& painter, const FilmLayout& layout, const std::vector<Method>& methods,
              bool captions, std::span<const FrameRecord> records, int frames_a_time)
      : painter_(painter),
        layout_(layout),
        captions_(captions),
        caption_painter_({painter.width(), painter.height()}),
        frame_(layout.emptyFrame()) {
    for (const Method method : methods) {
      painter.prepare(method);
      panels_.push_back({method, SteadyTime(frames_a_time), medianOf(method, records)});
    }
  }

  const Image& paint(const Walk& walk, std::size_t frame) {
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      Panel& panel = panels_[i];
      const FrameCost cost = painter_.paint(panel.method, walk.stepTo(frame, painter_));
      panel.shown_ms = panel.time.add(cost.frametime_ms);
      painter_.read(picture_);
      layout_.place(picture_, static_cast<int>(i), frame_);
      if (captions_) {
        caption_painter_.draw({infoOf(panel.method).name, panel.shown_ms, panel.median_ms},
                              layout_.corner(static_cast<int>(i)), frame_);
      }
    }
    return frame_;
  }

 private:
  struct Panel {
    Method method;
    SteadyTime time;
    double median_ms;
    double shown_ms = 0;
  };
  FramePainter& painter_;
  const FilmLayout& layout_;
  bool captions_;
  CaptionPainter caption_painter_;
  std::vector<Panel> panels_;
  Image picture_, frame_;
};

}  // namespace

Film::Film(const FilmParameters& parameters, const std::string& output,
           const std::vector<Method>& methods, const glm::ivec2& panel)
    : parameters_(parameters),
      methods_(methods),
      format_(filmFormatOf(parameters.file)),
      ffmpeg_(findFfmpeg()),
      staged_(output),
      layout_(static_cast<int>(methods.size()), panel) {}

void Film::shoot(FramePainter& painter, const Walk& walk, std::span<const FrameRecord> records,
                 const ProgressSink& progress) {
  constexpr int kTimesASecond = 3;  // that the times shown change
  const auto report = [&](std::size_t done) {
    if (!progress) return;
    progress("making the film", static_cast<double>(done) / static_cast<double>(walk.frames()));
  };
  FilmPainter film(painter, layout_, methods_, parameters_.captions.value_or(methods_.size() > 1),
                   records, std::max(1, parameters_.frames_per_second / kTimesASecond));
  FfmpegPipe ffmpeg(ffmpeg_, ffmpegArguments(format_, layout_.size(), parameters_.frames_per_second,
                                             staged_.path()));
  for (std::size_t frame = 0; frame < walk.frames(); ++frame) {
    report(frame);
    ffmpeg.halt();
    const Image& picture = film.paint(walk, frame);
    ffmpeg.goOn();
    ffmpeg.write(picture.rgba);
  }
  ffmpeg.finish();
  staged_.commit();
  frames_ = walk.frames();
  report(frames_);
}

std::string Film::description() const {
  return fmt::format("film: {}: {} frames of {} x {} pixels, {:.1f} s\n", parameters_.file, frames_,
                     layout_.size().x, layout_.size().y,
                     static_cast<double>(frames_) / parameters_.frames_per_second);
}

}  // namespace enfilade
