#include "scene/gltf_nodes.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace enfilade {
namespace {

constexpr std::uint32_t kNoParent = 0xffffffffu;

const tinygltf::Node& nodeAt(const GltfModel& gltf, int node) {
  if (node < 0 || static_cast<std::size_t>(node) >= gltf->nodes.size()) {
    gltf.fail(fmt::format("is no valid glTF: there is no node {}", node));
  }
  return gltf->nodes[static_cast<std::size_t>(node)];
}

/// Every node's parent, -1 for none.
std::vector<int> parentsOf(const GltfModel& gltf) {
  std::vector<int> parents(gltf->nodes.size(), -1);
  for (std::size_t n = 0; n < gltf->nodes.size(); ++n) {
    for (const int child : gltf->nodes[n].children) {
      nodeAt(gltf, child);
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent >= 0) {
        gltf.fail(fmt::format("is no valid glTF: node {} '{}' is the child of two nodes", child,
                              oneLine(nodeAt(gltf, child).name)));
      }
      parent = static_cast<int>(n);
    }
  }
  return parents;
}

std::vector<int> sceneRoots(const GltfModel& gltf, const std::vector<int>& parents) {
  if (!gltf->scenes.empty()) {
    const auto scene = static_cast<std::size_t>(std::max(gltf->defaultScene, 0));
    return gltf->scenes[scene < gltf->scenes.size() ? scene : 0].nodes;
  }
  std::vector<int> roots;
  for (std::size_t n = 0; n < parents.size(); ++n) {
    if (parents[n] < 0) roots.push_back(static_cast<int>(n));
  }
  // Nodes but no root: all of them are below themselves.
  if (roots.empty() && !parents.empty()) roots.push_back(0);
  return roots;
}

/// Whether each node is in the scene; `parents` of the scene's roots become -1.
std::vector<bool> nodesInScene(const GltfModel& gltf, std::vector<int>& parents) {
  std::vector<bool> in_scene(gltf->nodes.size(), false);
  std::vector<int> pending = sceneRoots(gltf, parents);
  std::sort(pending.begin(), pending.end());
  pending.erase(std::unique(pending.begin(), pending.end()), pending.end());
  for (const int root : pending) {
    nodeAt(gltf, root);
    parents[static_cast<std::size_t>(root)] = -1;
  }
  while (!pending.empty()) {
    const int node = pending.back();
    pending.pop_back();
    if (in_scene[static_cast<std::size_t>(node)]) {
      gltf.fail(fmt::format("is no valid glTF: node {} '{}' is below itself, or twice in the scene",
                            node, oneLine(nodeAt(gltf, node).name)));
    }
    in_scene[static_cast<std::size_t>(node)] = true;
    const std::vector<int>& children = nodeAt(gltf, node).children;
    pending.insert(pending.end(), children.begin(), children.end());
  }
  return in_scene;
}

template <std::size_t N>
void checkNumbers(const GltfModel& gltf, int node, const std::vector<double>& values,
                  const char* what) {
  const bool finite =
      std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (values.empty() || (values.size() == N && finite)) return;
  gltf.fail(fmt::format("is no valid glTF: the {} of node {} '{}' is not {} finite numbers", what,
                        node, oneLine(nodeAt(gltf, node).name), N));
}

}  // namespace

GltfNodeTree readNodeTree(const GltfModel& gltf) {
  std::vector<int> parents = parentsOf(gltf);
  const std::vector<bool> in_scene = nodesInScene(gltf, parents);
  GltfNodeTree tree;
  std::vector<std::uint32_t> entry_of(gltf->nodes.size(), kNoParent);
  std::vector<int> chain;
  for (std::size_t n = 0; n < gltf->nodes.size(); ++n) {
    if (!in_scene[n]) continue;
    // Ancestors that the file has later come first.
    for (int a = static_cast<int>(n); a >= 0 && entry_of[static_cast<std::size_t>(a)] == kNoParent;
         a = parents[static_cast<std::size_t>(a)]) {
      chain.push_back(a);
    }
    for (; !chain.empty(); chain.pop_back()) {
      const int node = chain.back();
      const int parent = parents[static_cast<std::size_t>(node)];
      entry_of[static_cast<std::size_t>(node)] = static_cast<std::uint32_t>(tree.entries.size());
      tree.entries.push_back(
          {node, parent < 0 ? kNoParent : entry_of[static_cast<std::size_t>(parent)]});
    }
  }
  return tree;
}

glm::dmat4 composeTransform(const glm::dvec3& translation, const glm::dvec4& rotation_xyzw,
                            const glm::dvec3& scale) {
  const double length = glm::length(rotation_xyzw);
  const glm::dvec4 q = length > 0.0 ? rotation_xyzw / length : glm::dvec4(0, 0, 0, 1);
  glm::dmat4 m = glm::mat4_cast(glm::dquat(q.w, q.x, q.y, q.z));
  for (int i = 0; i < 3; ++i) m[i] *= scale[i];
  m[3] = glm::dvec4(translation, 1.0);
  return m;
}

glm::dmat4 parentFromNode(const GltfModel& gltf, int gltf_node) {
  const tinygltf::Node& node = nodeAt(gltf, gltf_node);
  checkNumbers<16>(gltf, gltf_node, node.matrix, "matrix");
  checkNumbers<3>(gltf, gltf_node, node.translation, "translation");
  checkNumbers<4>(gltf, gltf_node, node.rotation, "rotation");
  checkNumbers<3>(gltf, gltf_node, node.scale, "scale");
  if (!node.matrix.empty()) {
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    return m;
  }
  const auto& t = node.translation;
  const auto& r = node.rotation;
  const auto& s = node.scale;
  return composeTransform(t.empty() ? glm::dvec3(0) : glm::dvec3(t[0], t[1], t[2]),
                          r.empty() ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(r[0], r[1], r[2], r[3]),
                          s.empty() ? glm::dvec3(1) : glm::dvec3(s[0], s[1], s[2]));
}

glm::dmat4 multiplyThrough(const glm::dmat4& world_from_parent,
                           const glm::dmat4& parent_from_node) {
  glm::dmat4 product;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      double sum = 0.0;
      double magnitude = 0.0;
      for (int k = 0; k < 4; ++k) {
        const double term = world_from_parent[k][r] * parent_from_node[c][k];
        sum += term;
        magnitude += std::abs(term);
      }
      product[c][r] = std::abs(sum) <= 1e-14 * magnitude ? 0.0 : sum;
    }
  }
  return product;
}

}  // namespace enfilade
