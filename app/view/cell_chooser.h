#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/view/theme.h"
#include "portals/cell_graph.h"
#include "render/window_events.h"

namespace enfilade {

/// A list of the cells over the window, from which one is chosen by typing a part of its name, by
/// the arrows, or by a click.
class CellChooser {
 public:
  /// `graph` must outlive it.
  explicit CellChooser(const CellGraph& graph) : graph_(graph) {}

  void open();
  bool isOpen() const noexcept { return open_; }
  void close() { open_ = false; }

  /// Takes a key, a letter or a click.  Returns the cell that it chose, which closes the list.
  std::optional<CellId> take(const WindowEvent& event);

  void draw(OverlayPainter& overlay, const Theme& theme, const std::optional<glm::vec2>& pointer);

  /// The cells that are offered, of all whose name holds what was typed, whatever its case.
  const std::vector<CellId>& offered() const noexcept { return offered_; }

 private:
  void filter();
  std::optional<CellId> choose(std::size_t index);

  const CellGraph& graph_;
  bool open_ = false;
  bool opened_by_key_ = false;  // whose letter is still to come
  std::string typed_;
  std::vector<CellId> offered_;
  std::size_t chosen_ = 0;
  std::size_t first_ = 0;       // of those on screen
  std::vector<PixelBox> rows_;  // of those on screen
};

}  // namespace enfilade
