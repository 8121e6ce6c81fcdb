#include "portals/json_value.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/error.h"

namespace enfilade {

JsonValue::JsonValue(const nlohmann::json& json, std::string path, const std::string& file)
    : json_(json), path_(std::move(path)), file_(file) {}

void JsonValue::fail(const std::string& reason) const {
  throw Error(ErrorKind::kBadInput, file_, path_.empty() ? reason : path_ + " " + reason);
}

JsonValue JsonValue::operator[](const char* key) const {
  if (!json_.is_object()) fail("is not an object");
  const auto found = json_.find(key);
  const std::string path = path_.empty() ? key : path_ + "." + key;
  if (found == json_.end()) throw Error(ErrorKind::kBadInput, file_, path + " is missing");
  return {*found, path, file_};
}

bool JsonValue::has(const char* key) const {
  if (!json_.is_object()) fail("is not an object");
  return json_.contains(key);
}

std::size_t JsonValue::size() const {
  if (!json_.is_array()) fail("is not an array");
  return json_.size();
}

JsonValue JsonValue::at(std::size_t i) const {
  return {json_[i], fmt::format("{}[{}]", path_, i), file_};
}

void JsonValue::forEachMember(
    const std::function<void(const std::string&, const JsonValue&)>& visit) const {
  if (!json_.is_object()) fail("is not an object");
  for (const auto& [key, member] : json_.items()) {
    visit(key, JsonValue(member, path_ + "." + key, file_));
  }
}

bool JsonValue::isNull() const { return json_.is_null(); }

bool JsonValue::isString() const { return json_.is_string(); }

bool JsonValue::boolean() const {
  if (!json_.is_boolean()) fail("is neither true nor false");
  return json_.get<bool>();
}

std::string JsonValue::string() const {
  if (!json_.is_string()) fail("is not a string");
  return json_.get<std::string>();
}

double JsonValue::number() const {
  if (!json_.is_number()) fail("is not a number");
  const auto value = json_.get<double>();
  if (!std::isfinite(value)) fail("is out of range");
  return value;
}

float JsonValue::real() const {
  const double value = number();
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) fail("is out of range");
  return static_cast<float>(value);
}

float JsonValue::positive() const {
  const float value = real();
  if (!(value > 0)) fail("is not positive");
  return value;
}

glm::vec3 JsonValue::vector() const {
  if (size() != 3) fail("has not three numbers");
  return {at(0).real(), at(1).real(), at(2).real()};
}

std::uint32_t JsonValue::index(std::size_t count) const {
  if (!json_.is_number_unsigned()) fail("is not a whole number");
  if (json_.get<std::uint64_t>() >= count) fail(fmt::format("is not less than {}", count));
  return json_.get<std::uint32_t>();
}

std::uint64_t JsonValue::checksum() const {
  const std::string text = string();
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (text.size() != 16 || error != std::errc() || end != text.data() + text.size()) {
    fail("is not a checksum");
  }
  return value;
}

}  // namespace enfilade
