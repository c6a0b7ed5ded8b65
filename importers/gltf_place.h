#pragma once

#include <cstdint>
#include <string>

#include "importers/gltf_json.h"

namespace restframe {

// A value in the document that knows its JSON pointer, for faults. Places refer to their parents,
// which must outlive them. The getters of members check type and range.
class Place {
 public:
  Place(const GltfContext& context, const Json& root) : context_(&context), value_(&root) {}

  const Json& value() const { return *value_; }
  const GltfContext& context() const { return *context_; }
  std::string pointer() const;
  [[noreturn]] void fault(const std::string& what) const { context_->fault(pointer(), what); }

  bool has(const char* key) const { return value_->contains(key); }
  Place member(const char* key) const&;
  Place element(std::size_t index) const&;
  Place member(const char* key) const&& = delete;
  Place element(std::size_t index) const&& = delete;
  std::size_t size() const { return value_->size(); }

  void require_object() const;
  void require_array() const;
  void require_member(const char* key) const;
  std::uint64_t as_integer(std::uint64_t least, std::uint64_t greatest) const;
  double as_number(double least, double greatest) const;
  std::string as_string() const;

  // An optional member; `otherwise` where it is missing.
  std::uint64_t integer(const char* key, std::uint64_t least, std::uint64_t greatest,
                        std::uint64_t otherwise) const;
  // An optional index into something that has `count` elements; -1 where it is missing.
  std::int64_t index(const char* key, std::size_t count) const;
  void check_number(const char* key, double least, double greatest) const;
  void check_numbers(const char* key, std::size_t count, double least, double greatest) const;
  void check_boolean(const char* key) const;
  void check_string(const char* key) const;

 private:
  Place(const Place& parent, const Json& value, const char* key, std::size_t index)
      : context_(parent.context_), value_(&value), parent_(&parent), key_(key), index_(index) {}

  const GltfContext* context_;
  const Json* value_;
  const Place* parent_ = nullptr;
  const char* key_ = nullptr;  // the member's, or null for an element
  std::size_t index_ = 0;
};

// Calls body(element) for the elements of an optional array of objects.
template <class Body>
void for_each_object(const Place& place, const char* key, const Body& body) {
  if (!place.has(key)) return;
  const Place array = place.member(key);
  array.require_array();
  for (std::size_t i = 0; i < array.size(); ++i) {
    const Place element = array.element(i);
    element.require_object();
    body(element);
  }
}

}  // namespace restframe
