// Furniture of wood: flat faces, few triangles.
#include <algorithm>
#include <cmath>

#include "models/moulded_block.h"
#include "models/noise.h"
#include "models/shapes.h"

namespace enfilade {
namespace {

glm::dmat4 moved(double x, double y, double z) {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

Shape makeBench(const ShapeNumbers& n) {
  const double x = 0.5 * n.at("width"), z = 0.5 * n.at("depth"), h = n.at("height");
  return {{}, [=](MeshBuilder& mesh) {
            constexpr double kLeg = 0.06, kSeat = 0.09, kTop = 0.035, kGrain = 0.6;
            for (const double sx : {-1.0, 1.0}) {
              for (const double sz : {-1.0, 1.0}) {
                const glm::dvec3 foot(sx * (x - kLeg), 0, sz * (z - kLeg));
                const glm::dvec3 half(0.5 * kLeg, 0, 0.5 * kLeg);
                mesh.box(foot - half, foot + half + glm::dvec3(0, h - kSeat, 0), "XxZz", kGrain);
              }
            }
            mesh.box({-x, h - kSeat, -z}, {x, h - kTop, z}, "XxyZz", kGrain);
            mesh.setTint(glm::dvec3(0.92));
            mesh.setTransform(moved(0, h - kTop, 0));
            raiseMouldedBlock({x, z},
                              {{0, 0, 0.8}, {0.008, 0.012, 1}, {0, 0.03, 1}, {-0.02, kTop, 1}},
                              kGrain, mesh);
          }};
}

/// A row of books that fills `width`, their backs to +z, each of its own size and colour.
void raiseBooks(std::uint32_t seed, double width, double height, double depth, MeshBuilder& mesh) {
  constexpr double kColors[][3] = {{0.35, 0.08, 0.06}, {0.10, 0.16, 0.09}, {0.07, 0.10, 0.22},
                                   {0.42, 0.28, 0.10}, {0.22, 0.12, 0.06}, {0.45, 0.40, 0.30},
                                   {0.16, 0.05, 0.09}, {0.06, 0.16, 0.18}};
  double x = 0.01;
  for (std::int64_t i = 0;; ++i) {
    const double thick = 0.03 + 0.045 * hash01(seed, i, 0);
    if (x + thick > width - 0.01) break;
    const double high = height * (0.68 + 0.26 * hash01(seed, i, 1));
    const double front = depth * (0.80 + 0.12 * hash01(seed, i, 2));
    const auto& color = kColors[static_cast<std::size_t>(7.99 * hash01(seed, i, 3))];
    mesh.setTint(glm::dvec3(color[0], color[1], color[2]) * (0.8 + 0.5 * hash01(seed, i, 4)));
    if (hash01(seed, i, 5) > 0.08)
      mesh.box({x, 0, 0.03}, {x + thick - 0.002, high, front}, "XxYZ", 0.3);
    x += thick;
  }
  mesh.setTint(glm::dvec3(1));
}

/// The measures that a bookcase and its books share.
struct Bookcase {
  explicit Bookcase(const ShapeNumbers& n)
      : half(0.5 * n.at("width")),
        height(n.at("height")),
        depth(n.at("depth")),
        shelves(static_cast<int>(n.at("shelves"))),
        seed(static_cast<std::uint32_t>(n.at("seed"))) {}

  double shelfTop(int i) const { return kFoot + (height - kFoot - kBoard) / shelves * i + kShelf; }

  static constexpr double kBoard = 0.035, kShelf = 0.025;
  static constexpr double kFoot = 0.14;  // hides the skirting behind
  double half, height, depth;
  int shelves;
  std::uint32_t seed;
};

void raiseCase(const Bookcase& b, MeshBuilder& mesh) {
  const double in = b.half - Bookcase::kBoard, d = b.depth, grain = 0.7;
  mesh.box({-b.half, 0, 0}, {-in, b.height, d}, "xXZ", grain);
  mesh.box({in, 0, 0}, {b.half, b.height, d}, "xXZ", grain);
  mesh.box({-in, 0, 0.01}, {in, Bookcase::kFoot, d - 0.02}, "Z", grain);
  mesh.setTint(glm::dvec3(0.5));
  mesh.box({-in, Bookcase::kFoot, 0}, {in, b.height, 0.012}, "Z", grain);
  mesh.setTint(glm::dvec3(1));
  for (int i = 0; i <= b.shelves; ++i) {
    const double y = b.shelfTop(i);
    mesh.box({-in, y - Bookcase::kShelf, 0.012}, {in, y, d - 0.01}, "YyZ", grain);
  }
  mesh.box({-b.half - 0.02, b.height, 0}, {b.half + 0.02, b.height + 0.06, d + 0.03}, "xXyYZ",
           grain);
}

Shape makeBookcase(const ShapeNumbers& n) {
  const Bookcase b(n);
  if (n.at("books") <= 0) return {{}, [=](MeshBuilder& mesh) { raiseCase(b, mesh); }};
  return {{}, [=](MeshBuilder& mesh) {
            for (int i = 0; i < b.shelves; ++i) {
              const double in = b.half - Bookcase::kBoard, y = b.shelfTop(i);
              mesh.setTransform(moved(-in, y, 0));
              raiseBooks(b.seed * 97 + static_cast<std::uint32_t>(i), 2 * in,
                         b.shelfTop(i + 1) - Bookcase::kShelf - y, b.depth, mesh);
            }
            mesh.setTransform(glm::dmat4(1));
          }};
}

}  // namespace

std::vector<ShapeKind> furnitureKinds() {
  return {
      {"bench",
       0,
       {{"width", 1.6, 0.3, 10}, {"depth", 0.5, 0.2, 3}, {"height", 0.46, 0.2, 2}},
       makeBench},
      {"bookcase",
       0,
       {{"width", 1.2, 0.3, 5},
        {"height", 2.3, 0.5, 5},
        {"depth", 0.32, 0.1, 1},
        {"shelves", 6, 1, 12},
        {"seed", 1, 0, 1e6},
        {"books", 0, 0, 1}},
       makeBookcase},
  };
}

}  // namespace enfilade
