#pragma once

#include <tiny_obj_loader.h>

#include <string>
#include <vector>

#include "scene/building.h"
#include "scene/obj_reader.h"
#include "scene/warning_log.h"

namespace enfilade {

/// Adds the materials of an OBJ to the building, in their order, with their pictures, and one more
/// for faces without.  A picture named twice is read once.
void addObjMaterials(const std::vector<tinyobj::material_t>& materials,
                     const ObjResources& resources, Building& building, WarningLog& warnings);

}  // namespace enfilade
