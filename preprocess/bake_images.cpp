#include "preprocess/bake_images.h"

#include <filesystem>
#include <mutex>
#include <thread>

#include "ibr/ldi_file.h"
#include "ibr/portal_capture.h"
#include "ibr/portal_side.h"
#include "ibr/raycast_ldi.h"
#include "portals/open_doors.h"
#include "preprocess/bake_views.h"
#include "preprocess/side_folder.h"
#include "preprocess/work_crew.h"
#include "render/renderer.h"
#include "scene/error.h"
#include "visibility/object_index.h"
#include "visibility/portal_culling.h"

namespace enfilade {

namespace {

/// What all sides need, and nothing changes.
struct Baking {
  Baking(const House& the_house, const ImageParameters& the_parameters, const std::string& to)
      : house(the_house),
        parameters(the_parameters),
        folder(to),
        index(house),
        far_depth(farDepth(house.building, parameters)) {
    if (parameters.ldi == LdiMaking::kRayCast) {
      caster = std::make_unique<RayCaster>(house.building, openDoors(house), 1);
    }
  }

  const House& house;
  const ImageParameters& parameters;
  const std::string& folder;
  ObjectIndex index;
  double far_depth;
  std::unique_ptr<RayCaster> caster;  ///< if images are made by rays
  std::function<void()> checkpoint;
};

/// Bakes one side after another on one thread, with an OpenGL context of its own.
class SideBaker {
 public:
  SideBaker(const Baking& baking, GlBackend gl, int threads_to_draw)
      : baking_(baking),
        context_(createGlContext(gl, threads_to_draw)),
        renderer_(*context_, baking.house.building) {}

  /// Writes the images of `side` into its folder.
  void bake(const PortalSide& side) {
    const SideFolder folder(baking_.folder, side);
    if (baking_.parameters.bake.ldis) writeLdi(folder.path() + "/" + ldiFileName(), makeLdi(side));
    bakeSideViews(side, folder.path());
    folder.commit();
  }

 private:
  ObjectsInView objectsBehind(const PortalSide& side) const {
    return [this, side](const View& view) {
      if (baking_.checkpoint) baking_.checkpoint();
      return baking_.index.visible(
          cullBehindPortal(baking_.house.graph, view, side.portal, side.from_front));
    };
  }

  float eyeLevel(const PortalSide& side) const {
    const CellGraph& graph = baking_.house.graph;
    return eyeLevelBefore(graph, graph.portals[side.portal], side.from_front,
                          baking_.house.eye_height);
  }

  Ldi makeLdi(const PortalSide& side) {
    const ImageParameters& parameters = baking_.parameters;
    const Portal& portal = baking_.house.graph.portals[side.portal];
    const ObjectsInView objects = objectsBehind(side);
    return baking_.caster ? raycastLdi(*baking_.caster, portal, side.from_front, eyeLevel(side),
                                       parameters, objects, baking_.far_depth)
                          : bakeLdi(renderer_, portal, side.from_front, eyeLevel(side), parameters,
                                    objects, baking_.far_depth);
  }

  void bakeSideViews(const PortalSide& side, const std::string& folder) {
    const ObjectsInView objects = objectsBehind(side);
    const CaptureFunction capture = [&](const PlanarCamera& camera) {
      return captureThroughPortal(renderer_, camera, objects, baking_.far_depth);
    };
    bakeViews(baking_.house.graph.portals[side.portal], side.from_front, eyeLevel(side),
              baking_.parameters, capture, folder);
  }

  const Baking& baking_;
  std::unique_ptr<GlContext> context_;
  Renderer renderer_;
};

/// How the threads are shared out.
struct Hands {
  int bakers;   ///< each with a copy of the building in its context
  int drawing;  ///< llvmpipe's, which all contexts share
};

/// Two bakers that draw for themselves keep 1.45 of two cores busy over a whole preprocessing of
/// the gallery, one baker with two of llvmpipe's threads 1.15.  Not measured beyond four threads,
/// where the rest are given to llvmpipe.  Rays use all threads for one side.
Hands handsFor(int threads, const ImageParameters& parameters) {
  constexpr int kMostBakers = 4;
  if (threads <= 0) threads = static_cast<int>(std::thread::hardware_concurrency());
  if (parameters.ldi == LdiMaking::kRayCast) return {1, 1};
  return {std::min(threads, kMostBakers), threads > kMostBakers ? threads - kMostBakers : 1};
}

/// Lists the images of `side` in `house`; false if they are not all there.
bool listImages(const PortalSide& side, const std::string& folder, House& house) {
  const auto files = bakedFiles(folder, side);
  if (!files) return false;
  for (const auto& [name, checksum] : *files) house.files[name] = checksum;
  return true;
}

void requireImages(const PortalSide& side, const std::string& folder, House& house) {
  if (listImages(side, folder, house)) return;
  throw Error(ErrorKind::kMachine, portalImageFolder(folder, side.portal, side.from_front),
              "is not as it was written: something else is at work there");
}

std::uint64_t bytesOfImages(const House& house, const std::string& folder) {
  std::uint64_t sum = 0;
  for (const auto& [name, checksum] : house.files) {
    if (name.starts_with("images/")) sum += std::filesystem::file_size(folder + "/" + name);
  }
  return sum;
}

/// Bakes `sides`, of `all` those that are not yet baked.
void bakeSides(const Baking& baking, const std::vector<PortalSide>& sides, std::size_t all,
               const BakingHands& given, const ProgressSink& progress) {
  std::mutex telling;
  std::size_t done = all - sides.size();
  const auto tell = [&] {
    if (progress) progress(kBakingStage, static_cast<double>(done) / static_cast<double>(all));
  };
  if (done > 0) tell();
  const Hands hands = handsFor(given.threads, baking.parameters);
  shareOutJobs(sides.size(), hands.bakers, [&] {
    return
        [&, baker = std::make_shared<SideBaker>(baking, given.gl, hands.drawing)](std::size_t i) {
          baker->bake(sides[i]);
          const std::lock_guard lock(telling);
          ++done;
          tell();
        };
  });
}

}  // namespace

std::vector<PortalSide> sidesWithImages(const CellGraph& graph) {
  std::vector<PortalSide> sides;
  for (PortalId id = 0; id < graph.portals.size(); ++id) {
    for (const bool from_front : {true, false}) {
      if (getsImage(graph.portals[id], from_front)) sides.push_back({id, from_front});
    }
  }
  return sides;
}

BakedImages bakeImages(House& house, const ImageParameters& parameters, const std::string& folder,
                       const BakingHands& hands, const ProgressSink& progress) {
  const std::vector<PortalSide> sides = sidesWithImages(house.graph);
  std::vector<PortalSide> left;
  for (const PortalSide& side : sides) {
    if (!listImages(side, folder, house)) left.push_back(side);
  }
  if (hands.sides) hands.sides(sides.size() - left.size(), sides.size());
  if (!left.empty()) {
    Baking baking(house, parameters, folder);
    baking.checkpoint = hands.checkpoint;
    bakeSides(baking, left, sides.size(), hands, progress);
  }
  for (const PortalSide& side : left) requireImages(side, folder, house);
  return {sides.size(), bytesOfImages(house, folder)};
}

}  // namespace enfilade
