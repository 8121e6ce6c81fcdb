#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/film_format.h"
#include "app/film_layout.h"
#include "app/frame_record.h"
#include "app/staged_file.h"
#include "app/walk.h"
#include "preprocess/progress.h"

namespace enfilade {

struct FilmParameters {
  std::string file;                   ///< empty: no film
  int frames_per_second = 30;         ///< [1…240]
  std::optional<bool> captions = {};  ///< unless told: of two methods and more
};

/// A film of a walk by one method, or by several side by side, made by the program ffmpeg.
class Film {
 public:
  /// Begins `output`, where `parameters.file` is to be written, of pictures of `panel` pixels.
  /// Before the long work, as it throws Error for what would fail then: kUsage for the file's
  /// extension, kMachine where there is no ffmpeg or the file cannot be written.
  Film(const FilmParameters& parameters, const std::string& output,
       const std::vector<Method>& methods, const glm::ivec2& panel);

  /// Paints the walk, a frame of the film each, and puts the film in its place.  The times written
  /// into it are those of painting its own frames, while ffmpeg stands still; the medians those of
  /// `records`.  Throws Error (kMachine), Interrupted.
  void shoot(FramePainter& painter, const Walk& walk, std::span<const FrameRecord> records,
             const ProgressSink& progress);

  /// "film: tour.mp4: 520 frames of 1284 x 512 pixels, 17.3 s", with its line's end.
  std::string description() const;

 private:
  FilmParameters parameters_;
  std::vector<Method> methods_;
  FilmFormat format_;
  std::string ffmpeg_;
  StagedFile staged_;
  FilmLayout layout_;
  std::size_t frames_ = 0;
};

}  // namespace enfilade
