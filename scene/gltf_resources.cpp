#include "scene/gltf_resources.h"

#include <fmt/format.h>
#include <sodium.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/model_folder.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Of files beside the model: what may be read in any case, and how often each of them on average.
constexpr std::uint64_t kAlways = std::uint64_t{64} << 20;
constexpr std::uint64_t kMostCopies = 16;

[[noreturn]] void fail(const std::string& file, const std::string& reason) {
  throw Error(ErrorKind::kBadInput, file, reason);
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percentDecoded(const std::string& uri) {
  std::string decoded;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
    if (low < 0) {
      decoded += uri[i];
    } else {
      decoded += static_cast<char>(16 * high + low);
      i += 2;
    }
  }
  return decoded;
}

/// The path of what `uri` names, proved to lie inside the folder of `model_file`.
fs::path insideFolder(const std::string& model_file, const std::string& uri) {
  return fileInModelFolder(model_file, percentDecoded(uri));
}

/// Decodes "data:[type][;base64],…".
std::vector<std::uint8_t> decodeDataUri(const std::string& model_file, const std::string& uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos) fail(model_file, "a data URI is damaged");
  if (!std::string_view(uri).substr(0, comma).ends_with(";base64")) {
    const std::string text = percentDecoded(uri.substr(comma + 1));
    return {text.begin(), text.end()};
  }
  const std::string text =
      uri.find('%', comma) == std::string::npos ? "" : percentDecoded(uri.substr(comma + 1));
  const char* begin = text.empty() ? uri.data() + comma + 1 : text.data();
  std::size_t length = text.empty() ? uri.size() - comma - 1 : text.size();
  while (length > 0 && begin[length - 1] == '=') --length;
  std::vector<std::uint8_t> bytes(length / 4 * 3 + 3);
  std::size_t size = 0;
  if (sodium_base642bin(bytes.data(), bytes.size(), begin, length, " \r\n\t", &size, nullptr,
                        sodium_base64_VARIANT_ORIGINAL_NO_PADDING) != 0) {
    fail(model_file, "a data URI is not valid base64");
  }
  bytes.resize(size);
  return bytes;
}

bool isDataUri(const std::string& uri) { return uri.starts_with("data:"); }

}  // namespace

GltfResources::GltfResources(const std::string& model_file, std::span<const std::uint8_t> bin,
                             json& root, WarningLog& warnings)
    : model_file_(model_file) {
  takeBuffers(bin, root);
  takeImages(root, warnings);
}

const std::span<const std::uint8_t>* GltfResources::find(const std::string& key) const {
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? nullptr : &found->second;
}

std::span<const std::uint8_t> GltfResources::load(const std::string& uri) {
  if (isDataUri(uri)) {
    owned_.push_back(decodeDataUri(model_file_, uri));
    return owned_.back();
  }
  const std::string file = insideFolder(model_file_, uri).string();
  if (!by_file_.contains(file)) {
    owned_.push_back(readFile(file));
    by_file_[file] = owned_.back();
    owned_bytes_ += owned_.back().size();
  }
  // tinygltf makes a copy for each name.
  named_bytes_ += by_file_[file].size();
  if (named_bytes_ > kAlways && named_bytes_ / kMostCopies > owned_bytes_) {
    fail(model_file_,
         "names the same files again and again, " + std::to_string(named_bytes_) + " bytes in all");
  }
  return by_file_[file];
}

void GltfResources::takeBuffers(std::span<const std::uint8_t> bin, json& root) {
  if (!root.contains("buffers")) return;
  std::size_t index = 0;
  for (json& buffer : root["buffers"]) {
    const std::string key = fmt::format("buffer-{}", index);
    const auto length = buffer.is_object() ? buffer.find("byteLength") : buffer.end();
    if (!buffer.is_object() || length == buffer.end() || !length->is_number_unsigned() ||
        *length == 0u) {
      fail(model_file_, fmt::format("is no valid glTF: buffer {} has no length", index));
    }
    const auto uri = buffer.find("uri");
    const bool has_uri = uri != buffer.end() && uri->is_string();
    if (!has_uri && (index > 0 || bin.empty())) {
      fail(model_file_,
           fmt::format("buffer {} names no file, and there is no binary chunk for it", index));
    }
    const auto bytes = has_uri ? load(uri->get_ref<const std::string&>()) : bin;
    const auto promised = length->get<std::uint64_t>();
    if (promised > bytes.size()) {
      fail(model_file_, fmt::format("is damaged: buffer {} has {} of its {} bytes", index,
                                    bytes.size(), promised));
    }
    by_key_[key] = bytes.first(promised);
    buffer["uri"] = key;
    ++index;
  }
}

void GltfResources::takeImages(json& root, WarningLog& warnings) {
  if (!root.contains("images")) return;
  std::size_t index = 0;
  for (json& image : root["images"]) {
    const std::string key = fmt::format("image-{}", index++);
    if (!image.is_object() || !image.contains("uri") || !image["uri"].is_string()) continue;
    const std::string uri = image["uri"];
    image["uri"] = key;
    if (!image.contains("name") && !isDataUri(uri)) image["name"] = uri;
    if (!isDataUri(uri)) insideFolder(model_file_, uri);  // outside: an error, not a warning
    try {
      by_key_[key] = load(uri);
    } catch (const Error& error) {
      warnings.add("picture left out", oneLine(error.what(), 200));
    }
  }
}

}  // namespace enfilade
