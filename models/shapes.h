#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "models/curved_surface.h"

namespace enfilade {

/// A number that describes a shape: its name, value unless told otherwise, limits.
struct ShapeParameter {
  const char* name;
  double fallback;
  double least;
  double most;
};

using ShapeNumbers = std::map<std::string, double>;  ///< one for each of the shape's parameters

/// A shape, ready to be raised: curved surfaces whose triangles can be chosen, and flat parts whose
/// triangles are what they are.  Stands on y = 0 and looks to +z.
struct Shape {
  std::vector<CurvedSurface> surfaces;
  std::function<void(MeshBuilder&)> flat;  ///< may be empty
};

/// A kind of shape that plans can name.
struct ShapeKind {
  const char* name;
  double triangles;  ///< of the curved surfaces at detail 1
  std::vector<ShapeParameter> parameters;
  Shape (*make)(const ShapeNumbers& numbers);

  const ShapeParameter* find(const std::string& parameter) const;
};

/// The kinds that there are, each list in the file of its name.
std::vector<ShapeKind> sculptureKinds();
std::vector<ShapeKind> bustKinds();
std::vector<ShapeKind> turneryKinds();
std::vector<ShapeKind> masonryKinds();
std::vector<ShapeKind> furnitureKinds();
std::vector<ShapeKind> hangingKinds();
std::vector<ShapeKind> plantKinds();
std::vector<ShapeKind> stairwayKinds();

const ShapeKind* findShape(const std::string& name);  ///< nullptr if there is none
std::vector<std::string> shapeNames();

/// Triangles that raiseShape adds for `triangles` of the curved surfaces.
std::size_t countTriangles(const Shape& shape, double triangles);
void raiseShape(const Shape& shape, double triangles, MeshBuilder& mesh);

}  // namespace enfilade
