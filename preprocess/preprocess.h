#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ibr/image_parameters.h"
#include "portals/house.h"
#include "preprocess/cell_proposal.h"
#include "preprocess/object_roles.h"
#include "preprocess/progress.h"
#include "render/gl_context.h"

namespace enfilade {

/// Everything that preprocessing can be told.
struct PreprocessParameters {
  /// Name patterns of openable doors, joined by commas; empty: none.
  std::string doors = kUsualDoors;
  /// Name patterns of windows that can be seen through; blended material always is.
  std::string windows = kUsualWindows;
  std::string graph;  ///< a house.json whose cells and portals are taken as given, see
                      ///< readGivenGraph(), with its doors and windows where none are named here;
                      ///< empty: none.  It must not lie in the house's own folder.
  bool automatic = false;   ///< pass over the rooms and portals that the author named
  bool named_only = false;  ///< take no others than those, if there are any
  bool images = true;       ///< bake the portals' images
  bool bake_light = false;  ///< light the building through the portals to its exterior first
  CellParameters cells;
  ImageParameters image;
  float eye_height = 1.6f;  ///< [m] [0.2…3] above the floor
  int rays_per_cell =
      200000;  ///< [≥ 0] sight lines sampled from every cell to see what its portals show
  GlBackend gl = GlBackend::kOsMesa;  ///< that draws the images' captures
  int threads = 0;                    ///< [≥ 0] 0: as many as the machine has
};

/// How long a stage took.
struct StageTime {
  std::string stage;
  double seconds = 0;
};

struct PreprocessResult {
  House house;
  std::vector<StageTime> stages;
  std::size_t images = 0;  ///< portal sides with an image
  std::uint64_t image_bytes = 0;
};

/// Who is told of the work, and may stop it: by throwing, from any of these.
struct PreprocessListener {
  ProgressSink progress;
  std::function<void(const std::string& line)> note = {};  ///< what a person should know
  /// Before the baking: portal sides that are finished already, and all.
  std::function<void(std::size_t finished, std::size_t all)> sides = {};
  std::function<void()> checkpoint = {};  ///< called every few captures, from any thread
};

/// Reads the model at `model_file`, finds its cells and portals, shares its geometry out to the
/// cells, bakes the portals' images and puts the house into `folder`, which is locked meanwhile. An
/// old house there stays whole until the new one takes its place; a folder that holds something
/// else is refused.  However this ends, killed at any moment, the next run with the same model and
/// parameters goes on from the cells, once found, and from every finished portal side, and makes
/// the same bytes as one that was never interrupted; see UnfinishedHouse. The same bytes for the
/// same model and parameters, whatever the threads; by EGL on the same machine.  Throws Error:
/// kBadInput for the model or the graph, kUsage for a graph or other things in the folder, kMachine
/// for the folder, one that is in use, or the machine.
PreprocessResult preprocessBuilding(const std::string& model_file, const std::string& folder,
                                    const PreprocessParameters& parameters,
                                    const PreprocessListener& listener = {});

}  // namespace enfilade
