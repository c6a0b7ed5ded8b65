#include "importers/gltf_place.h"

#include <cmath>

namespace restframe {

std::string Place::pointer() const {
  if (parent_ == nullptr) return "/";
  std::string text = parent_->parent_ == nullptr ? "" : parent_->pointer();
  text += '/';
  text += key_ != nullptr ? key_ : std::to_string(index_);
  return text;
}

Place Place::member(const char* key) const& {
  return Place(*this, (*value_)[key], key, 0);
}

Place Place::element(std::size_t index) const& {
  return Place(*this, (*value_)[index], nullptr, index);
}

void Place::require_object() const {
  if (!value_->is_object()) fault(std::string("is ") + value_->type_name() + ", must be an object");
}

void Place::require_array() const {
  if (!value_->is_array()) fault(std::string("is ") + value_->type_name() + ", must be an array");
}

void Place::require_member(const char* key) const {
  if (!has(key)) fault(std::string(key) + " is missing");
}

std::uint64_t Place::as_integer(std::uint64_t least, std::uint64_t greatest) const {
  if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() < least ||
      value_->get<std::uint64_t>() > greatest) {
    fault("is " + (value_->is_number() ? value_->dump() : std::string(value_->type_name())) +
          ", must be a whole number from " + std::to_string(least) + " to " +
          std::to_string(greatest));
  }
  return value_->get<std::uint64_t>();
}

double Place::as_number(double least, double greatest) const {
  if (!value_->is_number()) fault(std::string("is ") + value_->type_name() + ", must be a number");
  const auto number = value_->get<double>();
  if (!(number >= least && number <= greatest)) {
    fault("is " + value_->dump() + ", must be from " + Json(least).dump() + " to " +
          Json(greatest).dump());
  }
  return number;
}

std::string Place::as_string() const {
  if (!value_->is_string()) fault(std::string("is ") + value_->type_name() + ", must be a string");
  return value_->get<std::string>();
}

std::uint64_t Place::integer(const char* key, std::uint64_t least, std::uint64_t greatest,
                             std::uint64_t otherwise) const {
  return has(key) ? member(key).as_integer(least, greatest) : otherwise;
}

std::int64_t Place::index(const char* key, std::size_t count) const {
  if (!has(key)) return -1;
  const Place place = member(key);
  if (!place.value().is_number_unsigned() || place.value().get<std::uint64_t>() >= count) {
    const std::string shown =
        place.value().is_number() ? place.value().dump() : place.value().type_name();
    place.fault("is " + shown +
                (count == 0 ? ", but there is nothing that it could refer to"
                            : ", must be an index below " + std::to_string(count)));
  }
  return place.value().get<std::int64_t>();
}

void Place::check_number(const char* key, double least, double greatest) const {
  if (has(key)) member(key).as_number(least, greatest);
}

void Place::check_numbers(const char* key, std::size_t count, double least, double greatest) const {
  if (!has(key)) return;
  const Place array = member(key);
  array.require_array();
  if (array.size() != count) {
    array.fault("has " + std::to_string(array.size()) + " numbers, must have " +
                std::to_string(count));
  }
  for (std::size_t i = 0; i < count; ++i) array.element(i).as_number(least, greatest);
}

void Place::check_boolean(const char* key) const {
  if (has(key) && !member(key).value().is_boolean()) member(key).fault("must be true or false");
}

void Place::check_string(const char* key) const {
  if (has(key)) member(key).as_string();
}

}  // namespace restframe
