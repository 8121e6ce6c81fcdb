#include "preprocess/surface_albedo.h"

#include <array>
#include <cmath>

namespace enfilade {
namespace {

constexpr float kMost = 0.9f;
constexpr float kHue = 0.5f;  // what is kept of it

/// The mean colour of a picture, linear, weighted by alpha.
glm::vec3 meanColor(const Image& image) {
  std::array<double, 256> linear{};
  for (std::size_t i = 0; i < 256; ++i) linear[i] = std::pow(static_cast<double>(i) / 255, 2.2);
  glm::dvec3 sum(0);
  double weight = 0;
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
    const double alpha = image.rgba[i + 3];
    sum += alpha *
           glm::dvec3(linear[image.rgba[i]], linear[image.rgba[i + 1]], linear[image.rgba[i + 2]]);
    weight += alpha;
  }
  return weight > 0 ? glm::vec3(sum / weight) : glm::vec3(1);
}

}  // namespace

AlbedoOf::AlbedoOf(const Building& building) : building_(building) {
  std::vector<glm::vec3> means;
  for (const TextureImage& image : building.images) means.push_back(meanColor(image.image));
  for (const Material& material : building.materials) {
    const glm::vec3 picture = material.image == kNone ? glm::vec3(1) : means[material.image];
    of_material_.push_back(glm::vec3(material.base_color) * picture);
  }
}

glm::vec3 AlbedoOf::at(std::uint32_t object, std::uint32_t vertex) const {
  const Mesh& mesh = building_.meshOf(building_.objects[object]);
  const VertexArrays& vertices = building_.vertex_arrays[mesh.vertices];
  glm::vec3 albedo = of_material_[mesh.material];
  if (!vertices.colors.empty()) albedo *= glm::vec3(vertices.colors[vertex]) / 65535.0f;
  const float grey = glm::dot(albedo, glm::vec3(0.2126f, 0.7152f, 0.0722f));
  return glm::clamp(glm::mix(glm::vec3(grey), albedo, kHue), 0.0f, kMost);
}

}  // namespace enfilade
