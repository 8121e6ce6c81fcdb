#pragma once

#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "models/zip_archive.h"
#include "scene/building.h"

namespace enfilade {

/// Where Debian's package sweethome3d-furniture installs its catalogues.
inline constexpr const char* kFurnitureFolder = "/usr/share/sweethome3d/furniture";

/// A piece of furniture in a catalogue.
struct FurnitureEntry {
  std::string id;    ///< "Scopia#bed1"
  std::string name;  ///< "Bed"
  std::string creator, licence;
  std::string model;          ///< of its OBJ in the catalogue
  glm::dvec3 size{1};         ///< [m] width, height, depth
  double top = 1;             ///< [m] above its foot: where things stand on it
  glm::dmat3 rotation{1};     ///< of the OBJ, before it is brought to size
  std::size_t catalogue = 0;  ///< of the library's
};

/// The furniture catalogues of Sweet Home 3D (.sh3f: ZIPs of Wavefront OBJ with sizes and names).
class FurnitureLibrary {
 public:
  /// Opens all catalogues in `folder`.  Throws Error: kMachine if there are none, which names the
  /// package; kBadInput for one that is damaged.
  explicit FurnitureLibrary(const std::string& folder = kFurnitureFolder);
  /// Of one catalogue, the bytes of `file`.  Throws Error (kBadInput) if it is damaged.
  FurnitureLibrary(std::vector<std::uint8_t> bytes, const std::string& file);

  /// By id, in order.
  const std::map<std::string, FurnitureEntry>& entries() const noexcept { return entries_; }

  /// Null if there is none of that id.
  const FurnitureEntry* find(const std::string& id) const;

  /// The piece as it stands: its foot's middle in the origin, looking to +z, brought to its size by
  /// its nodes' transform.  Throws Error (kBadInput) that names the catalogue.
  Building load(const FurnitureEntry& entry) const;

 private:
  void addCatalogue(std::unique_ptr<ZipArchive> archive, const std::string& file);

  std::vector<std::string> files_;
  std::vector<std::unique_ptr<ZipArchive>> catalogues_;
  std::map<std::string, FurnitureEntry> entries_;
};

}  // namespace enfilade
