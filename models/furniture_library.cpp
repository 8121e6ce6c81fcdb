#include "models/furniture_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <sstream>

#include "models/java_properties.h"
#include "scene/error.h"
#include "scene/obj_reader.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

/// The numbered properties of one piece.
class Properties {
 public:
  Properties(const std::map<std::string, std::string>& all, int number, const std::string& file)
      : all_(all), suffix_("#" + std::to_string(number)), file_(file) {}

  bool has(const char* key) const { return all_.contains(key + suffix_); }
  std::string text(const char* key) const {
    const auto found = all_.find(key + suffix_);
    return found == all_.end() ? std::string() : found->second;
  }
  /// Centimetres in the file.
  double metres(const char* key, double otherwise) const {
    return has(key) ? numbers(key, 1)[0] / 100 : otherwise;
  }
  std::vector<double> numbers(const char* key, std::size_t count) const {
    std::istringstream stream(text(key));
    stream.imbue(std::locale::classic());
    std::vector<double> values;
    for (double value = 0; stream >> value;) values.push_back(value);
    if (values.size() != count || !stream.eof()) {
      throw Error(ErrorKind::kBadInput, file_,
                  fmt::format("{}{} is not {} numbers", key, suffix_, count));
    }
    return values;
  }

 private:
  const std::map<std::string, std::string>& all_;
  std::string suffix_;
  const std::string& file_;
};

std::string withoutSlash(std::string name) {
  name.erase(0, name.find_first_not_of('/'));
  return name;
}

void requireSound(const FurnitureEntry& entry, const std::string& file) {
  const auto fail = [&](const char* what) {
    throw Error(ErrorKind::kBadInput, file, entry.id + " has " + what);
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (!(entry.size[axis] > 0 && entry.size[axis] <= 100)) {
      fail("a size that is not between 0 and 100 m");
    }
  }
  if (!(entry.top <= 100)) fail("a dropOnTopElevation of over 100 m");
  bool small = true;  // or else a shear
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) small &= std::abs(entry.rotation[column][row]) < 1.1;
  }
  if (!small || !(std::abs(std::abs(glm::determinant(entry.rotation)) - 1) < 0.1)) {
    fail("a modelRotation that is no rotation");
  }
}

FurnitureEntry entryOf(const Properties& properties) {
  FurnitureEntry entry;
  entry.id = properties.text("id");
  entry.name = properties.text("name");
  entry.creator = properties.text("creator");
  entry.model = withoutSlash(properties.text("model"));
  entry.size = {properties.metres("width", 1), properties.metres("height", 1),
                properties.metres("depth", 1)};
  entry.top = properties.metres("dropOnTopElevation", entry.size.y);
  if (!(entry.top > 0)) entry.top = entry.size.y;
  if (properties.has("modelRotation")) {
    const std::vector<double> rows = properties.numbers("modelRotation", 9);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        entry.rotation[column][row] = rows[static_cast<std::size_t>(3 * row + column)];
      }
    }
  }
  return entry;
}

/// From the OBJ's coordinates to the piece as it stands.
glm::dmat4 standing(const FurnitureEntry& entry, const Building& model) {
  Box box;
  for (const Object& object : model.objects) {
    const Mesh& mesh = model.meshOf(object);
    for (const std::uint32_t i : mesh.indices) {
      const glm::dvec3 p(model.vertex_arrays[mesh.vertices].positions[i]);
      box.extend(glm::vec3(entry.rotation * p));
    }
  }
  const glm::dvec3 size(box.size()), middle(box.center());
  glm::dvec3 scale(1);
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] > 1e-6) scale[axis] = entry.size[axis] / size[axis];
  }
  const glm::dmat4 sized = glm::scale(glm::dmat4(1), scale);
  const glm::dvec3 foot(middle.x, static_cast<double>(box.min.y), middle.z);
  return glm::translate(sized, -foot) * glm::dmat4(entry.rotation);
}

}  // namespace

FurnitureLibrary::FurnitureLibrary(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> files;
  for (const auto& file : fs::directory_iterator(folder, error)) {
    if (file.path().extension() == ".sh3f") files.push_back(file.path().string());
  }
  std::sort(files.begin(), files.end());
  if (error && error != std::errc::no_such_file_or_directory) {
    throw Error(ErrorKind::kMachine, folder, "cannot be read: " + error.message());
  }
  if (files.empty()) {
    throw Error(ErrorKind::kMachine, folder,
                "holds no furniture catalogues (.sh3f); Debian's package sweethome3d-furniture "
                "installs them: apt-get install sweethome3d-furniture");
  }
  for (const std::string& file : files) addCatalogue(std::make_unique<ZipArchive>(file), file);
}

FurnitureLibrary::FurnitureLibrary(std::vector<std::uint8_t> bytes, const std::string& file) {
  addCatalogue(std::make_unique<ZipArchive>(std::move(bytes), file), file);
}

void FurnitureLibrary::addCatalogue(std::unique_ptr<ZipArchive> archive, const std::string& file) {
  const auto bytes = archive->read("PluginFurnitureCatalog.properties");
  if (!bytes) throw Error(ErrorKind::kBadInput, file, "is no furniture catalogue");
  const auto properties = readJavaProperties(*bytes);
  const auto licence = properties.find("license");
  for (int number = 1; properties.contains("id#" + std::to_string(number)); ++number) {
    FurnitureEntry entry = entryOf(Properties(properties, number, file));
    entry.licence = licence == properties.end() ? std::string() : licence->second;
    entry.catalogue = catalogues_.size();
    requireSound(entry, file);
    entries_.try_emplace(entry.id, entry);
  }
  files_.push_back(file);
  catalogues_.push_back(std::move(archive));
}

const FurnitureEntry* FurnitureLibrary::find(const std::string& id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second;
}

Building FurnitureLibrary::load(const FurnitureEntry& entry) const {
  const ZipArchive& archive = *catalogues_[entry.catalogue];
  const std::string subject = files_[entry.catalogue] + ": " + entry.model;
  const auto text = archive.read(entry.model);
  if (!text) throw Error(ErrorKind::kBadInput, subject, "is not there");
  const fs::path folder = fs::path(entry.model).parent_path();
  const auto beside = [&](const std::string& name) {
    auto bytes = archive.read((folder / name).lexically_normal().generic_string());
    const std::size_t slash = name.find_last_of("/\\");
    if (bytes || slash == std::string::npos) return bytes;
    return archive.read((folder / name.substr(slash + 1)).generic_string());
  };
  Building model = parseObj(*text, subject, beside);
  model.name = entry.id;
  const glm::mat4 place(standing(entry, model));
  for (Node& node : model.nodes) node.world_from_node = place;
  return model;
}

}  // namespace enfilade
