#include "models/zip_archive.h"

#include <zip.h>

#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{256} << 20;
/// Deflate makes 1032 bytes at most of one.
constexpr std::uint64_t kMostPerByte = 1032;

std::string textOf(int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

}  // namespace

ZipArchive::ZipArchive(const std::string& file) : file_(file) {
  int code = 0;
  archive_ = zip_open(file.c_str(), ZIP_RDONLY, &code);
  if (archive_ == nullptr) throw Error(ErrorKind::kBadInput, file, "is no ZIP: " + textOf(code));
}

ZipArchive::ZipArchive(std::vector<std::uint8_t> bytes, const std::string& file)
    : file_(file), bytes_(std::move(bytes)) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes_.data(), bytes_.size(), 0, &error);
  archive_ = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  const std::string reason = archive_ == nullptr ? zip_error_strerror(&error) : "";
  zip_error_fini(&error);
  if (archive_ != nullptr) return;
  zip_source_free(source);
  throw Error(ErrorKind::kBadInput, file, "is no ZIP: " + reason);
}

ZipArchive::~ZipArchive() { zip_discard(archive_); }

std::optional<std::vector<std::uint8_t>> ZipArchive::read(const std::string& name) const {
  zip_int64_t index = zip_name_locate(archive_, name.c_str(), 0);
  if (index < 0) index = zip_name_locate(archive_, name.c_str(), ZIP_FL_NOCASE);
  if (index < 0) return std::nullopt;
  const auto fail = [&](const std::string& reason) {
    throw Error(ErrorKind::kBadInput, file_, name + " " + reason);
  };
  zip_stat_t facts;
  const auto entry = static_cast<zip_uint64_t>(index);
  if (zip_stat_index(archive_, entry, 0, &facts) != 0 || !(facts.valid & ZIP_STAT_SIZE)) {
    fail("cannot be read");
  }
  if (facts.size > kMostBytes) fail("is larger than 256 MiB");
  if (!(facts.valid & ZIP_STAT_COMP_METHOD) || !(facts.valid & ZIP_STAT_COMP_SIZE) ||
      (facts.comp_method != ZIP_CM_STORE && facts.comp_method != ZIP_CM_DEFLATE)) {
    fail("is compressed by another method than deflate");
  }
  if (facts.size / kMostPerByte > facts.comp_size) fail("has a size that its bytes cannot hold");
  std::vector<std::uint8_t> bytes(facts.size);
  zip_file_t* stream = zip_fopen_index(archive_, entry, 0);
  if (stream == nullptr) fail("cannot be read");
  const zip_int64_t count = zip_fread(stream, bytes.data(), bytes.size());
  const bool closed = zip_fclose(stream) == 0;
  if (count != static_cast<zip_int64_t>(bytes.size()) || !closed) fail("is damaged");
  return bytes;
}

}  // namespace enfilade
