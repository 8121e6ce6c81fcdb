#include "models/json_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/error.h"
#include "scene/warning_log.h"

namespace enfilade {

void JsonView::fail(const std::string& reason) const {
  throw Error(ErrorKind::kBadInput, subject_, place_.empty() ? reason : place_ + ": " + reason);
}

void JsonView::allowOnly(std::initializer_list<const char*> keys) const {
  if (!value_->is_object()) fail("must be an object");
  for (const auto& [key, value] : value_->items()) {
    if (std::none_of(keys.begin(), keys.end(), [&](const char* k) { return key == k; })) {
      std::string known;
      for (const char* k : keys) known += (known.empty() ? "" : ", ") + std::string(k);
      fail(fmt::format("does not know \"{}\"; there are: {}", key, known));
    }
  }
}

bool JsonView::has(const char* key) const { return value_->is_object() && value_->contains(key); }

std::string JsonView::placeOf(const std::string& key) const {
  // Kept by every value in it, so not at any length.
  return place_.empty() ? oneLine(key) : place_ + "." + oneLine(key);
}

JsonView JsonView::at(const char* key) const {
  if (!value_->is_object()) fail("must be an object");
  if (!value_->contains(key)) fail(fmt::format("\"{}\" is missing", key));
  return {(*value_)[key], subject_, placeOf(key)};
}

std::vector<JsonView> JsonView::items() const {
  if (!value_->is_array()) fail("must be a list");
  std::vector<JsonView> views;
  for (std::size_t i = 0; i < value_->size(); ++i)
    views.emplace_back((*value_)[i], subject_, fmt::format("{}[{}]", place_, i));
  return views;
}

std::vector<std::pair<std::string, JsonView>> JsonView::members() const {
  if (!value_->is_object()) fail("must be an object");
  std::vector<std::pair<std::string, JsonView>> views;
  for (const auto& [key, value] : value_->items())
    views.emplace_back(key, JsonView(value, subject_, placeOf(key)));
  return views;
}

std::vector<JsonView> JsonView::itemsAt(const char* key, bool required) const {
  if (!required && !has(key)) return {};
  return at(key).items();
}

double JsonView::number(double least, double most) const {
  if (!value_->is_number()) fail("must be a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number) || number < least || number > most)
    fail(fmt::format("must be from {} to {}, is {}", least, most, number));
  return number;
}

double JsonView::numberAt(const char* key, double least, double most) const {
  return at(key).number(least, most);
}

double JsonView::numberAt(const char* key, double least, double most, double fallback) const {
  return has(key) ? numberAt(key, least, most) : fallback;
}

std::string JsonView::text() const {
  if (!value_->is_string()) fail("must be text");
  const auto text = value_->get<std::string>();
  if (text.empty()) fail("must not be empty");
  return text;
}

std::string JsonView::textAt(const char* key) const { return at(key).text(); }

std::string JsonView::textAt(const char* key, const std::string& fallback) const {
  return has(key) ? textAt(key) : fallback;
}

bool JsonView::flagAt(const char* key, bool fallback) const {
  if (!has(key)) return fallback;
  const JsonView view = at(key);
  if (!view.value_->is_boolean()) view.fail("must be true or false");
  return view.value_->get<bool>();
}

glm::dvec2 JsonView::pointAt(const char* key) const {
  const JsonView view = at(key);
  const auto parts = view.items();
  if (parts.size() != 2) view.fail("must be [x, z]");
  return {parts[0].number(-10000, 10000), parts[1].number(-10000, 10000)};
}

bool JsonView::isNumber() const { return value_->is_number(); }

}  // namespace enfilade
