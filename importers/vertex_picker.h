#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scene/mesh.h"

namespace restframe {

// Numbers the vertices of some of a mesh's triangles from 0 on, in the order in which they come;
// one such choice after the other, in time that does not depend on the whole.
class VertexPicker {
 public:
  explicit VertexPicker(std::size_t vertices) : numbers_(vertices, none) {}

  Triangle renumbered(Triangle triangle) {
    for (std::uint32_t& vertex : triangle) {
      std::uint32_t& number = numbers_[vertex];
      if (number == none) {
        number = static_cast<std::uint32_t>(picked_.size());
        picked_.push_back(vertex);
      }
      vertex = number;
    }
    return triangle;
  }

  // Ends the choice: the old number of each new one.
  std::vector<std::uint32_t> take() {
    for (const std::uint32_t vertex : picked_) numbers_[vertex] = none;
    return std::exchange(picked_, {});
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  std::vector<std::uint32_t> numbers_, picked_;
};

}  // namespace restframe
