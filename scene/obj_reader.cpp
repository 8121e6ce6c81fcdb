#include "scene/obj_reader.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/gtc/color_space.hpp>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <unordered_map>

#include "scene/building_repair.h"
#include "scene/error.h"
#include "scene/file_format.h"
#include "scene/file_io.h"
#include "scene/model_folder.h"
#include "scene/obj_materials.h"
#include "scene/polygon_triangles.h"
#include "scene/short_name.h"
#include "scene/warning_log.h"

namespace enfilade {
namespace {

/// An OBJ's text and the material libraries that it names, which tinyobjloader would look for by
/// rules of its own: one place in the text stands for all.
struct ObjText {
  std::string text;
  std::vector<std::string> libraries;  ///< what follows each mtllib
};

/// Makes one line of those of vertices and faces that end in a backslash and the next; a comment or
/// a name may end in one too.
void joinContinuedLines(std::string& text) {
  bool goes_on = false;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
    end = std::min(text.find('\n', at), text.size());
    const std::size_t first = text.find_first_not_of(" \t", at);
    const bool joins = goes_on || (first < end && (text[first] == 'f' || text[first] == 'v'));
    const std::size_t last = end > at && text[end - 1] == '\r' ? end - 1 : end;
    goes_on = joins && end < text.size() && last > at && text[last - 1] == '\\';
    if (goes_on) text.replace(last - 1, end + 2 - last, end + 2 - last, ' ');
  }
}

ObjText takeLibraries(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kWord = "mtllib";
  ObjText obj{{bytes.begin(), bytes.end()}, {}};
  for (std::size_t i = 0; i + 1 < obj.text.size(); ++i) {  // lines that end as on old Macintoshes
    if (obj.text[i] == '\r' && obj.text[i + 1] != '\n') obj.text[i] = '\n';
  }
  joinContinuedLines(obj.text);
  if (obj.text.starts_with("\xef\xbb\xbf")) obj.text.replace(0, 3, "   ");
  for (std::size_t at = 0; at < obj.text.size();) {
    const std::size_t end = std::min(obj.text.find('\n', at), obj.text.size());
    const std::size_t first = std::min(obj.text.find_first_not_of(" \t", at), end);
    const std::size_t name = first + kWord.size();
    if (obj.text.compare(first, kWord.size(), kWord) == 0 && name < end &&
        (obj.text[name] == ' ' || obj.text[name] == '\t')) {
      std::string rest = obj.text.substr(name, end - name);
      rest.erase(0, rest.find_first_not_of(" \t"));
      rest.erase(rest.find_last_not_of(" \t\r") + 1);
      const bool is_first = obj.libraries.empty();
      obj.libraries.push_back(std::move(rest));
      for (std::size_t i = is_first ? name : first; i < end; ++i) obj.text[i] = ' ';
      if (is_first) obj.text[name + 1 < end ? name + 1 : name] = 'x';
    }
    at = end + 1;
  }
  return obj;
}

/// Reads all material libraries by way of the resources.
class LibraryReader : public tinyobj::MaterialReader {
 public:
  LibraryReader(const std::vector<std::string>& libraries, const ObjResources& resources,
                WarningLog& warnings)
      : libraries_(libraries), resources_(resources), warnings_(warnings) {}

  bool operator()(const std::string&, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* by_name, std::string* warn,
                  std::string* err) override {
    std::set<std::string> known;
    const auto read = [&](const std::string& name) {
      if (known.contains(name)) return true;
      const auto bytes = resources_(name);
      if (!bytes) return false;
      std::istringstream text(std::string(bytes->begin(), bytes->end()));
      tinyobj::LoadMtl(by_name, materials, &text, warn, err);
      known.insert(name);
      return true;
    };
    for (const std::string& line : libraries_) {
      if (read(line)) continue;  // one file, its name perhaps with blanks
      std::istringstream names(line);
      for (std::string name; names >> name;) {
        if (read(name)) continue;
        warnings_.add("material library left out, it cannot be read from the model's folder",
                      "\"" + oneLine(name) + "\"");
      }
    }
    return true;
  }

 private:
  const std::vector<std::string>& libraries_;
  const ObjResources& resources_;
  WarningLog& warnings_;
};

/// What tinyobjloader makes of a file.
struct Source {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;

  bool hasColors() const { return attributes.colors.size() == attributes.vertices.size(); }
};

/// What tinyobjloader noticed, line by line, but for what is counted here as without area.
void addNotices(const std::string& text, WarningLog& warnings) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && (line.front() == '.' || line.front() == ' ')) line.erase(0, 1);
    if (!line.empty() && line != "Degenerated face found") {
      warnings.add("noticed", oneLine(line, 200));
    }
  }
}

std::size_t countWords(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  std::size_t count = 0;
  for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos; ++count) {
    at = line.find_first_not_of(kBlanks, std::min(line.find_first_of(kBlanks, at), line.size()));
  }
  return count;
}

/// The most corners of any face that it leaves in the text: to cut up one of very many corners
/// takes a time that grows with their square.
std::size_t takeLargeFaces(std::string& text, WarningLog& warnings) {
  constexpr std::size_t kMostCorners = 2048;
  std::size_t most = 0;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
    end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    if (line.size() < 512 || line.find_first_not_of(" \t") != line.find('f')) continue;
    const std::size_t corners = countWords(line) - 1;
    if (corners <= kMostCorners) {
      most = std::max(most, corners);
      continue;
    }
    warnings.add("faces of over 2048 corners left out", std::to_string(corners) + " corners");
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(at),
              text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
  }
  return most;
}

Source load(std::span<const std::uint8_t> bytes, const std::string& file,
            const ObjResources& resources, WarningLog& warnings) {
  ObjText obj = takeLibraries(bytes);
  // Of faces with more corners it loses count, unless it cuts them up itself, which it does well
  // for convex ones, as such faces are.
  const bool triangulate = takeLargeFaces(obj.text, warnings) > 255;
  Source source;
  LibraryReader libraries(obj.libraries, resources, warnings);
  std::istringstream text(obj.text);
  std::string warn, err;
  const bool read = tinyobj::LoadObj(&source.attributes, &source.shapes, &source.materials, &warn,
                                     &err, &text, &libraries, triangulate, false);
  if (!read) throw Error(ErrorKind::kBadInput, file, "is no valid OBJ: " + oneLine(err, 200));
  addNotices(warn, warnings);
  return source;
}

glm::vec3 vectorAt(const std::vector<float>& numbers, int index) {
  const auto i = 3 * static_cast<std::size_t>(index);
  return {numbers[i], numbers[i + 1], numbers[i + 2]};
}

/// The meshes of one shape, one a material, each with vertices of its own.
class ShapeReader {
 public:
  ShapeReader(const Source& source, const tinyobj::shape_t& shape, Building& building,
              WarningLog& warnings)
      : source_(source), shape_(shape), building_(building), warnings_(warnings) {}

  void read() {
    const auto& mesh = shape_.mesh;
    std::size_t first = 0;
    for (std::size_t face = 0; face < mesh.num_face_vertices.size(); ++face) {
      const int id = face < mesh.material_ids.size() ? mesh.material_ids[face] : -1;
      const bool known = id >= 0 && static_cast<std::size_t>(id) < source_.materials.size();
      const std::size_t count = mesh.num_face_vertices[face];
      addFace({&mesh.indices[first], count},
              known ? static_cast<std::uint32_t>(id)
                    : static_cast<std::uint32_t>(building_.materials.size() - 1));
      first += count;
    }
    if (!parts_.empty()) finish();
    if (!shape_.lines.indices.empty()) warnings_.add("lines left out", quotedName());
    if (!shape_.points.indices.empty()) warnings_.add("points left out", quotedName());
  }

 private:
  using Corner = std::array<int, 3>;  // position, coordinates, normal
  struct CornerHash {
    std::size_t operator()(const Corner& c) const {
      return (static_cast<std::size_t>(c[0]) * 0x9e3779b97f4a7c15u) ^
             (static_cast<std::size_t>(c[1]) * 0xc2b2ae3d27d4eb4fu) ^
             static_cast<std::size_t>(c[2]);
    }
  };
  struct Part {
    VertexArrays vertices;
    std::vector<std::uint32_t> indices;
    std::unordered_map<Corner, std::uint32_t, CornerHash> known;  // looked up, never walked through
  };

  std::string quotedName() const {
    return shape_.name.empty() ? "an object without a name" : "'" + oneLine(shape_.name) + "'";
  }

  static bool within(int index, std::size_t numbers, std::size_t each) {
    return index >= 0 && static_cast<std::size_t>(index) < numbers / each;
  }

  void addFace(std::span<const tinyobj::index_t> corners, std::uint32_t material) {
    const tinyobj::attrib_t& a = source_.attributes;
    positions_.clear();
    for (const tinyobj::index_t& corner : corners) {
      if (!within(corner.vertex_index, a.vertices.size(), 3)) {
        warnings_.add("faces with a corner that is not there, left out", quotedName());
        return;
      }
      const glm::vec3 p = vectorAt(a.vertices, corner.vertex_index);
      if (!(std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest &&
            std::abs(p.z) <= kFarthest)) {
        warnings_.add("faces with a corner that is no number within 1e12 m, left out",
                      quotedName());
        return;
      }
      positions_.push_back(p);
    }
    const auto triangles = polygonTriangles(positions_);
    if (triangles.empty()) warnings_.add("faces without area, left out", quotedName());
    for (const auto& triangle : triangles) {
      Part& part = parts_[material];
      const glm::vec3 flat =
          faceNormal(positions_[triangle[0]], positions_[triangle[1]], positions_[triangle[2]]);
      for (const std::size_t k : triangle) {
        part.indices.push_back(vertexOf(corners[k], positions_[k], flat, part));
      }
    }
  }

  std::uint32_t vertexOf(const tinyobj::index_t& corner, const glm::vec3& position,
                         const glm::vec3& flat, Part& part) {
    const tinyobj::attrib_t& a = source_.attributes;
    const bool has_normal = within(corner.normal_index, a.normals.size(), 3);
    const bool has_texcoord = within(corner.texcoord_index, a.texcoords.size(), 2);
    const auto next = static_cast<std::uint32_t>(part.vertices.positions.size());
    if (has_normal) {  // flat corners are shared by nobody
      const Corner key{corner.vertex_index, has_texcoord ? corner.texcoord_index : -1,
                       corner.normal_index};
      const auto [known, is_new] = part.known.try_emplace(key, next);
      if (!is_new) return known->second;
    }
    part.vertices.positions.push_back(position);
    part.vertices.normals.push_back(has_normal ? vectorAt(a.normals, corner.normal_index) : flat);
    glm::vec2 texcoord(0);
    if (has_texcoord) {
      const auto i = 2 * static_cast<std::size_t>(corner.texcoord_index);
      texcoord = {a.texcoords[i], 1.0f - a.texcoords[i + 1]};  // its row 0 is the lowest
      if (!std::isfinite(texcoord.x + texcoord.y)) texcoord = glm::vec2(0);
    }
    part.vertices.texcoords.push_back(texcoord);
    if (source_.hasColors()) {
      const glm::vec3 color = glm::clamp(vectorAt(a.colors, corner.vertex_index), 0.0f, 1.0f);
      glm::vec3 linear = glm::convertSRGBToLinear(color);
      for (int c = 0; c < 3; ++c) linear[c] = linear[c] > 0 ? linear[c] : 0.0f;  // nor a NaN
      part.vertices.colors.push_back(glm::u16vec4(glm::vec4(linear, 1.0f) * 65535.0f + 0.5f));
    }
    return next;
  }

  void finish() {
    const auto node = static_cast<std::uint32_t>(building_.nodes.size());
    Node named;
    named.name = shape_.name;
    shortenName(named.name);
    const std::string name = named.name;
    building_.nodes.push_back(std::move(named));
    for (auto& [material, part] : parts_) {
      Mesh mesh;
      mesh.name = name;
      mesh.material = material;
      mesh.vertices = static_cast<std::uint32_t>(building_.vertex_arrays.size());
      mesh.indices = std::move(part.indices);
      for (const glm::vec3& p : part.vertices.positions) mesh.bounds.extend(p);
      if (building_.materials[material].image == kNone) part.vertices.texcoords.clear();
      building_.vertex_arrays.push_back(std::move(part.vertices));
      building_.objects.push_back({node, static_cast<std::uint32_t>(building_.meshes.size())});
      building_.meshes.push_back(std::move(mesh));
    }
  }

  const Source& source_;
  const tinyobj::shape_t& shape_;
  Building& building_;
  WarningLog& warnings_;
  std::map<std::uint32_t, Part> parts_;  // by material
  std::vector<glm::vec3> positions_;     // of the face at hand
};

}  // namespace

bool looksLikeObj(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::string_view, 13> kWords{
      "v", "vn", "vt", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl", "usemap"};
  std::istringstream text(std::string(
      bytes.begin(), bytes.begin() + std::min<std::ptrdiff_t>(std::ssize(bytes), 65536)));
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    const std::size_t end = line.find_first_of(" \t\r", first);
    const std::string_view word = std::string_view(line).substr(first, end - first);
    return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
  }
  return false;
}

Building parseObj(std::span<const std::uint8_t> text, const std::string& file,
                  const ObjResources& resources, Warnings* warnings) {
  if (!looksLikeObj(text)) {
    throw Error(ErrorKind::kBadInput, file, "is no OBJ: " + guessFormat(text));
  }
  WarningLog log;
  const Source source = load(text, file, resources, log);
  Building building;
  building.name = std::filesystem::path(file).stem().string();
  addObjMaterials(source.materials, resources, building, log);
  for (const tinyobj::shape_t& shape : source.shapes) {
    ShapeReader(source, shape, building, log).read();
  }
  if (building.objects.empty())
    throw Error(ErrorKind::kBadInput, file, "holds no triangles" + log.because());
  mendNormals(building, log);
  if (warnings != nullptr) *warnings = log.lines();
  return building;
}

Building readObj(const std::string& file, Warnings* warnings) {
  const auto inside = [&](const std::string& name) -> std::optional<std::vector<std::uint8_t>> {
    try {
      const auto path = fileInModelFolder(file, name);
      std::error_code ignored;
      if (std::filesystem::is_regular_file(path, ignored)) return readFile(path.string());
    } catch (const Error&) {
    }
    return std::nullopt;
  };
  const auto beside = [&](const std::string& name) {
    // Exporters write the way to it on the author's machine.
    auto bytes = inside(name);
    const std::size_t folder = name.find_last_of("/\\");
    return bytes || folder == std::string::npos ? bytes : inside(name.substr(folder + 1));
  };
  constexpr std::uint64_t kMost = std::uint64_t{4} << 30;  // [bytes]: it takes five times as many
  return parseObj(readFile(file, kMost), file, beside, warnings);
}

}  // namespace enfilade
