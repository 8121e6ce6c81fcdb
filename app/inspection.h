#pragma once

#include <string>
#include <vector>

#include "app/ldi_layers.h"
#include "app/portal_images.h"
#include "portals/house.h"
#include "scene/building.h"

namespace enfilade {

/// What there is to say of a building, whether in a model or in a house.
struct BuildingFacts {
  std::size_t triangles = 0;  ///< over all objects
  std::size_t objects = 0, meshes = 0, nodes = 0;
  std::size_t closed_meshes = 0;  ///< every edge of which joins two triangles
  std::size_t materials = 0, masked = 0, blended = 0, double_sided = 0;
  std::size_t images = 0, image_pixels = 0;
  Box bounds;                     ///< [m]
  std::size_t rooms_named = 0;    ///< nodes named NAME-room, or with extras that say so
  std::size_t portals_named = 0;  ///< nodes named NAME-portal, or with extras that say so
  /// How many nodes have a name that begins so, up to a '/' or ':', as IFC converters write them.
  std::vector<std::pair<std::string, std::size_t>> kinds;
};

BuildingFacts describeBuilding(const Building& building);

/// What looks wrong with a building, a line each.
std::vector<std::string> buildingProblems(const BuildingFacts& facts);

/// What looks wrong with a house, a line each.
std::vector<std::string> houseProblems(const House& house);

/// What `enfilade inspect` prints of a model: text for people, or JSON.
std::string modelText(const std::string& file, const Building& building,
                      const std::vector<std::string>& warnings);
std::string modelJson(const std::string& file, const Building& building,
                      const std::vector<std::string>& warnings);

/// What `enfilade inspect` prints of a house and its images.
std::string houseText(const std::string& folder, const House& house, const ImageCounts& images);
/// With what is in the layers of its images, if that was asked for.
std::string houseJson(const std::string& folder, const House& house, const ImageCounts& images,
                      const std::vector<SideLayers>& layers = {});

}  // namespace enfilade
