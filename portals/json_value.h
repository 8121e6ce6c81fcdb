#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace enfilade {

/// A value of a JSON file that is checked as it is read: every getter throws Error (kBadInput) with
/// the file, the way to the value ("cells[3].name") and what is wrong with it.
/// Refers to the parsed JSON and to the file's name, which must outlive it.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& json, std::string path, const std::string& file);

  [[noreturn]] void fail(const std::string& reason) const;

  JsonValue operator[](const char* key) const;  ///< of an object; must be there
  bool has(const char* key) const;              ///< of an object
  std::size_t size() const;                     ///< of an array
  JsonValue at(std::size_t i) const;            ///< of an array, i < size()
  void forEachMember(
      const std::function<void(const std::string& key, const JsonValue& value)>& visit) const;

  bool isNull() const;
  bool isString() const;
  bool boolean() const;
  std::string string() const;
  double number() const;  ///< finite
  float real() const;     ///< in the range of float
  float positive() const;
  glm::vec3 vector() const;                      ///< three numbers
  std::uint32_t index(std::size_t count) const;  ///< a whole number less than `count`
  std::uint64_t checksum() const;                ///< 16 hexadecimal digits

 private:
  const nlohmann::json& json_;
  std::string path_;
  const std::string& file_;
};

}  // namespace enfilade
