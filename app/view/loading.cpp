#include "app/view/loading.h"

#include <chrono>
#include <filesystem>
#include <future>
#include <mutex>

#include "scene/error.h"

namespace enfilade {

namespace {

/// A line that one thread writes and another reads.
class SharedLine {
 public:
  void set(const std::string& line) {
    const std::lock_guard lock(mutex_);
    line_ = line;
  }
  std::string get() const {
    const std::lock_guard lock(mutex_);
    return line_;
  }

 private:
  mutable std::mutex mutex_;
  std::string line_;
};

void paintWaiting(GlfwWindow& window, OverlayPainter& overlay, const std::string& line) {
  const glm::ivec2 size = window.size();
  if (size.x < 1 || size.y < 1) return;
  Theme theme;
  theme.scale = window.contentScale();
  overlay.begin(size);
  overlay.box({glm::vec2(0), glm::vec2(size)}, {0.07f, 0.08f, 0.10f, 1});
  const auto centered = [&](const std::string& text, const TextStyle& style, float down) {
    const float x = 0.5f * (static_cast<float>(size.x) - overlay.textWidth(text, style));
    overlay.text(text, {x, 0.45f * static_cast<float>(size.y) + down * theme.scale}, style);
  };
  centered("Enfilade", theme.title(Theme::kAccent), 0);
  centered(line, theme.text(Theme::kFaint), 34);
  overlay.end();
  window.present();
}

}  // namespace

std::unique_ptr<WalkableHouse> loadWalkable(const ViewOptions& options,
                                            const std::function<void(const std::string&)>& tell) {
  const std::string name = std::filesystem::path(options.house).filename().string();
  auto walkable = std::make_unique<WalkableHouse>();
  if (!options.tour.empty()) {
    walkable->tour = readCameraPath(options.tour);
    if (walkable->tour->poses.empty()) {
      throw Error(ErrorKind::kBadInput, options.tour, "holds no poses");
    }
  }
  tell("reading " + (name.empty() ? options.house : name));
  walkable->house = readHouse(options.house);
  walkable->images =
      std::make_unique<ImageShelf>(walkable->house, options.house, options.most_bytes);
  const Method method = parseMethods(options.settings.method).front();
  if (options.source == ImageSource::kBaked && infoOf(method).portal_images) {
    tell("reading the portals' images");
    walkable->method_has_images = walkable->images->fetch(infoOf(method));
  }
  tell("finding where one can walk");
  walkable->walker = std::make_unique<Walker>(walkable->house);
  if (walkable->tour) PathPlayer(*walkable->tour, walkable->house, options.tour);  // its doors
  tell("handing the geometry over");
  return walkable;
}

std::unique_ptr<WalkableHouse> loadBehindWindow(GlfwWindow& window, const ViewOptions& options) {
  OverlayPainter overlay(window);
  SharedLine line;
  auto loading = std::async(std::launch::async, [&] {
    const auto tell = [&](const std::string& what) {
      line.set(what);
      GlfwWindow::wake();
    };
    std::unique_ptr<WalkableHouse> walkable = loadWalkable(options, tell);
    GlfwWindow::wake();
    return walkable;
  });
  while (loading.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    if (window.shouldClose()) return loading.get(), nullptr;
    paintWaiting(window, overlay, line.get());
    window.takeEvents(0.1);
  }
  paintWaiting(window, overlay, line.get());
  return loading.get();
}

}  // namespace enfilade
