#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ibr/depth_image.h"
#include "tests/bench/warp_scenes.h"

namespace enfilade::bench {

/// An image with depth and a view of its size to warp it to.
struct PeerScene {
  DepthImage image;
  PlanarCamera desired;
};

/// A library that warps images, too.
struct Peer {
  std::string name;
  /// Makes ready for a scene; what it returns warps once.
  std::function<std::function<void()>(const PeerScene&)> prepare;
};

/// Those that were found when this was built.
std::vector<Peer> foundPeers();

}  // namespace enfilade::bench
