#pragma once

#include <glm/glm.hpp>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace enfilade {

/// A value inside a JSON document that knows its own place, so that every complaint can name it.
/// All checks throw Error (kBadInput): "SUBJECT: PLACE: REASON".  The document must outlive it.
class JsonView {
 public:
  JsonView(const nlohmann::json& value, std::string subject, std::string place = {})
      : value_(&value), subject_(std::move(subject)), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& reason) const;

  /// Fails unless this is an object whose keys are all among `keys`.
  void allowOnly(std::initializer_list<const char*> keys) const;

  bool has(const char* key) const;
  JsonView at(const char* key) const;
  std::vector<JsonView> items() const;                            ///< of an array
  std::vector<std::pair<std::string, JsonView>> members() const;  ///< of an object, by key
  std::vector<JsonView> itemsAt(const char* key, bool required = true) const;

  double number(double least, double most) const;
  double numberAt(const char* key, double least, double most) const;
  double numberAt(const char* key, double least, double most, double fallback) const;
  std::string text() const;  ///< not empty
  std::string textAt(const char* key) const;
  std::string textAt(const char* key, const std::string& fallback) const;
  bool flagAt(const char* key, bool fallback) const;
  glm::dvec2 pointAt(const char* key) const;  ///< [x, z], within ±10 km
  bool isNumber() const;

 private:
  std::string placeOf(const std::string& key) const;

  const nlohmann::json* value_;
  std::string subject_;
  std::string place_;
};

}  // namespace enfilade
