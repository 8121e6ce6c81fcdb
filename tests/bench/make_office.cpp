// Makes an office block as a BIM program would export it, with what its author says of it beside
// it, to measure how finding rooms and doors scales: storeys of offices along corridors, door
// leaves shut, glazed windows, suspended ceilings, toilet cubicles, furniture, open stairwells.
//   make_office OUT.glb OUT.semantics.json [ROWS] [ROOMS A ROW] [STOREYS] [TURN, degrees]
// A row is 12.4 m deep: 5 m of office on either side of a corridor.  A room is 4 m wide.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "models/mesh_builder.h"
#include "scene/building.h"
#include "scene/gltf_writer.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

constexpr double kBay = 4.0, kDepth = 5.1, kCorridor = 2.2, kRow = 2 * kDepth + kCorridor;
constexpr double kStorey = 4.0, kCeiling = 2.8, kSlab = 0.3, kWall = 0.1;
constexpr double kDoor = 0.9, kHead = 2.05;

struct Hole {
  double from, to, sill, head;
};

class Office {
 public:
  Office(int rows, int bays, int storeys, double degrees)
      : rows_(rows), bays_(bays), storeys_(storeys) {
    turn_ = glm::rotate(glm::dmat4(1), glm::radians(degrees), glm::dvec3(0, 1, 0));
    building_.name = "office";
    building_.materials.resize(3);
    building_.materials[0].base_color = {0.8f, 0.8f, 0.75f, 1};
    building_.materials[1].base_color = {0.6f, 0.8f, 0.9f, 0.3f};
    building_.materials[1].alpha_mode = AlphaMode::kBlend;
    building_.materials[2].base_color = {0.5f, 0.35f, 0.2f, 1};
    json_["spaces"] = json_["doors"] = json_["windows"] = json_["openings"] = Json::array();
    json_["virtualBoundaries"] = Json::array();
  }

  void raise() {
    for (int s = 0; s < storeys_; ++s) raiseStorey(s);
    slab(storeys_ * kStorey, false);
    slab(-kSlab, false);
  }
  void write(const std::string& model, const std::string& semantics) const {
    writeGlb(model, building_);
    std::ofstream(semantics) << json_;
  }

 private:
  double width() const { return bays_ * kBay; }
  double length() const { return rows_ * kRow; }

  void finish(MeshBuilder& mesh, const std::string& name, std::uint32_t material) {
    if (mesh.triangleCount() == 0) return;
    Node node;
    node.name = name;
    building_.nodes.push_back(node);
    const auto n = static_cast<std::uint32_t>(building_.nodes.size() - 1);
    building_.objects.push_back({n, mesh.addTo(building_, name, material)});
    mesh = {};
    mesh.setTransform(turn_);
  }
  void box(const glm::dvec3& low, const glm::dvec3& high) { mesh_.box(low, high, "xXyYzZ"); }

  /// The slab under y, with a hole for the stairs.
  void slab(double y, bool stairs) {
    const double z1 = kDepth - kWall, x1 = kBay - kWall;
    mesh_.setTransform(turn_);
    if (stairs) {
      box({x1, y - kSlab, -0.15}, {width() + 0.15, y, z1});
      box({-0.15, y - kSlab, z1}, {width() + 0.15, y, length() + 0.15});
      box({-0.15, y - kSlab, -0.15}, {1.6, y, z1});
      box({1.6, y - kSlab, -0.15}, {x1, y, 0.4});
    } else {
      box({-0.15, y - kSlab, -0.15}, {width() + 0.15, y, length() + 0.15});
    }
    finish(mesh_, "IfcSlab/slab", 0);
  }

  /// A wall along x (or z) with holes in their order, centred on `at`.
  void wall(bool along_x, double at, double from, double to, double y,
            const std::vector<Hole>& holes, double thickness) {
    const double top = y + kStorey - kSlab;
    const auto piece = [&](double a, double b, double low, double high) {
      if (b - a < 1e-6 || high - low < 1e-6) return;
      const double h = thickness / 2;
      if (along_x) {
        box({a, low, at - h}, {b, high, at + h});
      } else {
        box({at - h, low, a}, {at + h, high, b});
      }
    };
    double done = from;
    for (const Hole& hole : holes) {
      piece(done, hole.from, y, top);
      piece(hole.from, hole.to, y, y + hole.sill);
      piece(hole.from, hole.to, y + hole.head, top);
      done = hole.to;
    }
    piece(done, to, y, top);
  }

  glm::dvec3 turned(const glm::dvec3& p) const { return glm::dvec3(turn_ * glm::dvec4(p, 1)); }
  static Json array(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

  std::string space(const std::string& name, const glm::dvec3& low, const glm::dvec3& high) {
    Json mesh{{"positions", Json::array()}, {"indices", Json::array()}};
    glm::dvec3 least(1e9), most(-1e9);
    for (unsigned i = 0; i < 8; ++i) {
      const glm::dvec3 p =
          turned({i & 1u ? high.x : low.x, i & 2u ? high.y : low.y, i & 4u ? high.z : low.z});
      least = glm::min(least, p);
      most = glm::max(most, p);
      for (int k = 0; k < 3; ++k) mesh["positions"].push_back(p[k]);
    }
    for (const unsigned i : {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                             2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6}) {
      mesh["indices"].push_back(i);
    }
    json_["spaces"].push_back({{"globalId", name},
                               {"name", name},
                               {"bounds", {{"min", array(least)}, {"max", array(most)}}},
                               {"mesh", mesh}});
    return name;
  }

  void opening(const char* kind, const std::string& name, bool along_x, const glm::dvec3& center,
               double width, double height, const std::string& a, const std::string& b) {
    const glm::dvec3 normal = along_x ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const auto side = [](const std::string& s) { return s.empty() ? Json() : Json(s); };
    json_[kind].push_back({{"name", name},
                           {"class", kind},
                           {"portal",
                            {{"center", array(turned(center))},
                             {"normal", array(turned(normal))},
                             {"width", width},
                             {"height", height}}},
                           {"spacesBySide", {side(a), side(b)}}});
  }

  /// A shut leaf in its frame.
  void door(double x, double y, double z, const std::string& a, const std::string& b) {
    const std::string name = fmt::format("IfcDoor/door-{}", json_["doors"].size());
    const double h = kDoor / 2;
    box({x - h, y, z - 0.02}, {x + h, y + kHead, z + 0.02});
    box({x - h, y, z - 0.07}, {x - h + 0.04, y + kHead, z + 0.07});
    box({x + h - 0.04, y, z - 0.07}, {x + h, y + kHead, z + 0.07});
    finish(mesh_, name, 2);
    opening("doors", name, true, {x, y + kHead / 2, z}, kDoor, kHead, a, b);
  }

  void window(double x, double y, double z, const std::string& a) {
    const std::string name = fmt::format("IfcWindow/window-{}", json_["windows"].size());
    box({x - 0.9, y + 0.9, z - 0.03}, {x - 0.84, y + 2.4, z + 0.03});
    box({x + 0.84, y + 0.9, z - 0.03}, {x + 0.9, y + 2.4, z + 0.03});
    box({x - 0.03, y + 0.9, z - 0.03}, {x + 0.03, y + 2.4, z + 0.03});
    box({x - 0.84, y + 0.9, z - 0.01}, {x - 0.03, y + 2.4, z + 0.01});
    box({x + 0.03, y + 0.9, z - 0.01}, {x + 0.84, y + 2.4, z + 0.01});
    finish(mesh_, name, 1);
    opening("windows", name, true, {x, y + 1.65, z}, 1.8, 1.5, a, "");
  }

  void furnish(double x, double y, double z, bool toilet) {
    if (toilet) {  // three cubicles with gaps below and above
      for (int i = 0; i < 3; ++i) {
        box({x - 1.9 + i * 1.2, y + 0.15, z + 0.6}, {x - 1.87 + i * 1.2, y + 2.0, z + 2.4});
        box({x - 1.87 + i * 1.2, y + 0.15, z + 0.6}, {x - 1.5 + i * 1.2, y + 2.0, z + 0.63});
      }
    } else {
      box({x - 0.8, y + 0.7, z - 0.4}, {x + 0.8, y + 0.74, z + 0.4});      // a desk
      box({x - 1.9, y, z - 2.0}, {x - 1.5, y + 2.0, z - 0.4});             // a cupboard
      box({x - 0.25, y + 0.42, z + 0.6}, {x + 0.25, y + 0.46, z + 1.05});  // a chair
      box({x - 0.25, y + 0.46, z + 1.0}, {x + 0.25, y + 0.95, z + 1.05});
    }
    finish(mesh_, "IfcFurnishingElement/furniture", 2);
  }

  void steps(double y) {
    constexpr int kSteps = 20;
    for (int i = 0; i < kSteps; ++i) {
      const double top = y + kStorey * (i + 1) / (kSteps + 1), z = 0.4 + 0.2 * i;
      box({1.7, top - 0.25, z}, {kBay - 0.2, top, z + 0.22});
    }
    finish(mesh_, "IfcStairFlight/stairs", 0);
  }

  void raiseStorey(int storey) {
    const double y = storey * kStorey;
    slab(y, storey > 0);
    for (int row = 0; row < rows_; ++row) raiseRow(storey, row);
    std::vector<Hole> ends;  // the corridors' doors at their ends, in the gable walls
    wall(false, 0, -0.15, length() + 0.15, y, ends, 0.3);
    wall(false, width(), -0.15, length() + 0.15, y, ends, 0.3);
    finish(mesh_, "IfcWallStandardCase/gables", 0);
  }

  void raiseRow(int storey, int row) {
    const double y = storey * kStorey, z0 = row * kRow, z3 = z0 + kRow;
    const double z1 = z0 + kDepth, z2 = z1 + kCorridor;
    const auto name = [&](const char* what, int i) {
      return fmt::format("{}-{}-{}-{}", what, storey, row, i);
    };
    const std::string corridor = space(name("corridor", 0), {0.15, y, z1 + kWall},
                                       {width() - 0.15, y + kCeiling, z2 - kWall});
    std::vector<Hole> outer, south, north;
    struct Fitting {
      double x, z;
      std::string a, b;
    };
    std::vector<Fitting> doors;
    for (int i = 0; i < bays_; ++i) {
      const double x = (i + 0.5) * kBay;
      const double door_x = x + 1.2;
      const bool stairs = i == 0 && row == 0;
      const double first = row == 0 ? z0 + 0.15 : z0 + kWall;
      const double last = row + 1 == rows_ ? z3 - 0.15 : z3 - kWall;
      const double left = i == 0 ? 0.15 : i * kBay + kWall;
      const double right = i + 1 == bays_ ? width() - 0.15 : (i + 1) * kBay - kWall;
      const double ceiling = y + (stairs ? kStorey - kSlab : kCeiling);
      const std::string a = space(name("south", i), {left, y, first}, {right, ceiling, z1 - kWall});
      const std::string b = space(name("north", i), {left, y, z2 + kWall}, {right, ceiling, last});
      south.push_back({door_x - kDoor / 2, door_x + kDoor / 2, 0, kHead});
      north.push_back(south.back());
      doors.push_back({door_x, z1, corridor, a});
      doors.push_back({door_x, z2, corridor, b});
      outer.push_back({x - 0.9, x + 0.9, 0.9, 2.4});
      if (stairs) {
        steps(y);
      } else {
        furnish(x, y, z0 + 2.5, i % 12 == 5);
      }
      furnish(x, y, z2 + 2.5, false);
      if (row == 0) window(x, y, z0, a);
      if (row + 1 == rows_) window(x, y, z3, b);
    }
    wall(true, z1, 0.15, width() - 0.15, y, south, 2 * kWall);
    wall(true, z2, 0.15, width() - 0.15, y, north, 2 * kWall);
    wall(true, z0, 0.15, width() - 0.15, y, row == 0 ? outer : std::vector<Hole>{},
         row == 0 ? 0.3 : 2 * kWall);
    if (row + 1 == rows_) wall(true, z3, 0.15, width() - 0.15, y, outer, 0.3);
    for (int i = 1; i < bays_; ++i) {
      wall(false, i * kBay, z0 + 0.1, z1 - 0.1, y, {}, 2 * kWall);
      wall(false, i * kBay, z2 + 0.1, z3 - 0.1, y, {}, 2 * kWall);
    }
    finish(mesh_, "IfcWallStandardCase/walls", 0);
    const double from = row == 0 ? kBay : 0.0;  // none over the stairs
    box({from, y + kCeiling, z0}, {width(), y + kCeiling + 0.03, z1});
    box({0, y + kCeiling, z1}, {width(), y + kCeiling + 0.03, z3});
    finish(mesh_, "IfcCovering/suspended ceiling", 0);
    for (const Fitting& f : doors) door(f.x, y, f.z, f.a, f.b);
  }

  int rows_, bays_, storeys_;
  glm::dmat4 turn_{1};
  Building building_;
  MeshBuilder mesh_;
  Json json_;
};

}  // namespace
}  // namespace enfilade

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "make_office OUT.glb OUT.semantics.json [ROWS] [ROOMS] [STOREYS] [TURN]\n");
    return 1;
  }
  const auto number = [&](int i, double otherwise) {
    return i < argc ? std::stod(argv[i]) : otherwise;
  };
  enfilade::Office office(int(number(3, 8)), int(number(4, 25)), int(number(5, 5)), number(6, 0));
  office.raise();
  office.write(argv[1], argv[2]);
  return 0;
}
