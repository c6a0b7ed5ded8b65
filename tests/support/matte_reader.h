#pragma once

// Cryptomatte as compositors read it: from the file alone, by its specification.

#include <bit>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/exr_reader.h"

namespace restframe {

class MatteReader {
 public:
  // Throws std::runtime_error if the header tells of no such layer.
  MatteReader(ExrPicture picture, const std::string& layer)
      : picture_(std::move(picture)), layer_(layer) {
    const std::string key = key_of(layer);
    if (picture_.attributes.at(key + "hash") != "MurmurHash3_32" ||
        picture_.attributes.at(key + "conversion") != "uint32_to_float32") {
      throw std::runtime_error("another hash or conversion");
    }
    manifest_text_ = picture_.attributes.at(key + "manifest");
    const std::map<std::string, std::string> ids = nlohmann::json::parse(manifest_text_);
    for (const auto& [name, id] : ids) {
      manifest_[name] = static_cast<std::uint32_t>(std::stoul(id, nullptr, 16));
    }
  }

  const ExrPicture& picture() const { return picture_; }
  const std::map<std::string, std::uint32_t>& manifest() const { return manifest_; }
  const std::string& manifest_text() const { return manifest_text_; }

  struct Rank {
    std::uint32_t id = 0;
    float coverage = 0;
  };
  // Those in use.
  std::vector<Rank> ranks(int x, int y) const {
    std::vector<Rank> all;
    for (int pair = 0; picture_.channels.count(channel(pair, 'R')) > 0; ++pair) {
      for (const char* of : {"RG", "BA"}) {
        const float id = picture_.at(channel(pair, of[0]), x, y);
        const float coverage = picture_.at(channel(pair, of[1]), x, y);
        if (id != 0 || coverage != 0) all.push_back({std::bit_cast<std::uint32_t>(id), coverage});
      }
    }
    return all;
  }

  double coverage(const std::string& name, int x, int y) const {
    double sum = 0;
    for (const Rank& rank : ranks(x, y)) {
      if (rank.id == manifest_.at(name)) sum += static_cast<double>(rank.coverage);
    }
    return sum;
  }
  double sum(int x, int y) const {
    double all = 0;
    for (const Rank& rank : ranks(x, y)) all += static_cast<double>(rank.coverage);
    return all;
  }
  // In pixels.
  double area(const std::string& name) const {
    double all = 0;
    for (int y = 0; y < picture_.height; ++y) {
      for (int x = 0; x < picture_.width; ++x) all += coverage(name, x, y);
    }
    return all;
  }

 private:
  std::string channel(int pair, char of) const {
    return layer_ + "0" + std::to_string(pair) + "." + of;
  }
  std::string key_of(const std::string& layer) const {
    for (const auto& [name, text] : picture_.attributes) {
      const bool names = name.starts_with("cryptomatte/") && name.ends_with("/name");
      if (names && text == layer) return name.substr(0, name.size() - 4);
    }
    throw std::runtime_error("no Cryptomatte " + layer);
  }

  ExrPicture picture_;
  std::string layer_, manifest_text_;
  std::map<std::string, std::uint32_t> manifest_;
};

}  // namespace restframe
