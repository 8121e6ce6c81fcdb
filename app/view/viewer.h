#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/path_player.h"
#include "app/path_recorder.h"
#include "app/view/cell_chooser.h"
#include "app/view/controls.h"
#include "app/view/frame_history.h"
#include "app/view/help_panel.h"
#include "app/view/image_shelf.h"
#include "app/view/layer_colors.h"
#include "app/view/plan_panel.h"
#include "app/view/resolution.h"
#include "app/view/toast.h"
#include "app/view/view_options.h"
#include "render/glfw_window.h"

namespace enfilade {

/// A house that is ready to be walked through.
struct WalkableHouse {
  House house;
  std::unique_ptr<ImageShelf> images;  ///< of `house`
  std::unique_ptr<Walker> walker;
  std::optional<CameraPath> tour;
  bool method_has_images = true;  ///< the one to begin with
};

/// A window to walk in: takes what a person does, moves, paints and shows.
class Viewer {
 public:
  /// Throws Error (kMachine).  All must outlive it.
  Viewer(GlfwWindow& window, WalkableHouse& walkable, const ViewOptions& options);

  /// Until the window is closed, or the program is asked to end (see Interruption).
  void run();

  /// Ends the recording and keeps its path, if one is being recorded.  What became of it, for a
  /// person; nothing if nothing was recorded.
  std::optional<std::string> keepRecording();

  /// What is to be remembered.
  ViewSettings settings() const;

 private:
  /// What is shown of how the picture is made.
  struct Inspection {
    bool portals = false, names = false, images = false, uncovered = false, layers = false,
         wires = false;
  };
  /// A half of the window, or all of it.
  struct Pane {
    Method method = Method::kLdi;
    FrameHistory history;
    VisibleSet seen;
    Image rays;   // by rays, which OpenGL does not know
    Image marks;  // on its pixels
  };

  void take(const WindowEvent& event);
  bool takePointer(const WindowEvent& event);
  void move(float seconds);
  void advanceTour(float seconds);
  void perform(const Command& command);
  void performInspection(Action action);
  void setMethod(Pane& pane, int number);
  void toggleSplit();
  void toggleDoor();
  void toggleRecording();
  void toggleTour();
  void toggleFreeze();
  void goTo(CellId cell);
  void goTo(const glm::vec3& eye);
  void goToStart();
  void standAt(const Pose& pose);
  void takeOver();
  bool coasts() const;
  void changeSpeed(float factor);
  void changeFieldOfView(float degrees);
  void keepPicture();
  void keepWindow();
  std::string keepName(const std::string& extension) const;

  void paintWindow();
  void paintPane(Pane& pane, const Camera& camera, float left, float right);
  void paintMarks(const Pane& pane, const Camera& camera, const PixelBox& box);
  void paintPanels(const Camera& camera);
  std::string placeLine() const;
  std::string notesLine() const;
  Pose pose() const { return held_pose_.value_or(walker_.pose()); }
  Camera camera(const glm::ivec2& size) const;
  float splitColumn() const;
  std::optional<glm::vec2> freePointer() const;

  GlfwWindow& window_;
  WalkableHouse& walkable_;
  House& house_;
  Walker& walker_;
  ViewOptions options_;
  FramePainter painter_;
  OverlayPainter overlay_;
  Theme theme_;
  Controls controls_;
  Resolution resolution_;
  PlanPanel plan_;
  HelpPanel help_;
  CellChooser chooser_;
  Toast toast_;
  LayerColors layer_colors_;

  Pane left_, right_;
  bool split_ = false;
  float split_at_ = 0.5f;  // share of the width
  bool dragging_ = false;
  Inspection inspection_;
  std::optional<Camera> frozen_;
  bool show_help_ = false, show_panels_ = true;
  glm::vec2 pointer_{0};
  Camera lens_;  // all of it but pose, field of view and shape: its far plane takes long to find
  float fov_;    // [rad]
  float speed_;  // [m/s]
  std::optional<Pose> held_pose_;  // of a path, until one moves by oneself
  bool moving_ = false;
  bool stale_ = true;                 // the window shows what is no more
  std::vector<std::uint8_t> open_;    // one a portal
  std::vector<std::uint8_t> stored_;  // likewise, as the house has them
  std::vector<std::uint8_t> closable_;

  double clock_ = 0;  // [s] that the viewer has run
  std::optional<PathRecorder> recorder_;
  std::vector<glm::vec3> trail_;  // of the path that is recorded
  std::optional<CameraPath> path_;
  std::unique_ptr<PathPlayer> playing_;
  double play_time_ = 0;
  std::optional<std::string> keep_window_as_;
};

}  // namespace enfilade
