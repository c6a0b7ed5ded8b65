#pragma once

// Which things cover a pixel, and how much of it each: what mattes are made of.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "frames/packet.h"

namespace restframe {

// What a matte tells apart.
enum class MatteKind : std::uint8_t { object, material, asset };
inline constexpr std::size_t matte_kinds = 3;

// Ids of all things in a scene, which stand for their names: things of one name share one. Lists of a
// kind that is not wanted are empty.
struct MatteIds {
  std::vector<std::uint32_t> objects;  // of each its own, then those of its parts' names
  std::vector<std::size_t> first;      // where each object's begin
  std::vector<std::uint32_t> materials, assets;
};

struct Cover {
  std::uint32_t id = 0;
  double weight = 0;  // in samples, as far as it was counted ...
  double most = 0;    // ... and at most: of what was met before
};

// The covers of one pixel, exactly if they are few. Of more ids than fit, the one of least `most` makes
// place for a new one, which may have been here before, with that much (the space-saving algorithm:
// Metwally, Agrawal and El Abbadi 2005). So no id misses more than 1/capacity of what covers the
// pixel, none has too much, and all that cover more than that are there. Samples come in one order
// whatever the threads: the same are always lost.
class CoverTable {
 public:
  static constexpr std::size_t capacity = 32;

  void clear() { size_ = 0; }
  void add(std::uint32_t id, float weight) {
    const auto more = static_cast<double>(weight);
    for (std::size_t i = 0; i < size_; ++i) {
      if (covers_[i].id != id) continue;
      covers_[i].weight += more;
      covers_[i].most += more;
      return;
    }
    if (size_ < capacity) {
      covers_[size_++] = {id, more, more};
    } else {
      Cover& least = least_cover();
      least = {id, more, least.most + more};
    }
  }
  std::span<const Cover> covers() const { return {covers_.data(), size_}; }

 private:
  Cover& least_cover() {
    return *std::min_element(covers_.begin(), covers_.end(),
                             [](const Cover& a, const Cover& b) { return a.most < b.most; });
  }

  std::array<Cover, capacity> covers_;
  std::size_t size_ = 0;
};

// The covers of the 16 pixels of a packet.
class CoverCounts {
 public:
  // `ids` must outlive the counts.
  explicit CoverCounts(const MatteIds& ids) : ids_(ids) {}

  void clear() {
    for (auto& lanes : tables_) {
      for (CoverTable& table : lanes) table.clear();
    }
  }

  // part_name: index into the object's part_names, or -1. weight: the share of a sample, up to 1.
  void add(int lane, int object, int part_name, int material, float weight) {
    if (!(weight > 0.0F)) return;
    const auto thing = static_cast<std::size_t>(object);
    if (!ids_.objects.empty()) {
      const std::size_t name = ids_.first[thing] + static_cast<std::size_t>(part_name + 1);
      table(MatteKind::object, lane).add(ids_.objects[name], weight);
    }
    if (!ids_.materials.empty()) {
      const std::uint32_t id = ids_.materials[static_cast<std::size_t>(material)];
      table(MatteKind::material, lane).add(id, weight);
    }
    if (!ids_.assets.empty()) table(MatteKind::asset, lane).add(ids_.assets[thing], weight);
  }

  std::span<const Cover> of(MatteKind kind, int lane) const {
    return tables_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(lane)].covers();
  }

 private:
  CoverTable& table(MatteKind kind, int lane) {
    return tables_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(lane)];
  }

  const MatteIds& ids_;
  std::array<std::array<CoverTable, packet_size>, matte_kinds> tables_;
};

}  // namespace restframe
