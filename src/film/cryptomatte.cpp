#include "film/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <nlohmann/json.hpp>

#include "film/aov.h"

namespace restframe {
namespace {

std::uint32_t mixed(std::uint32_t block) {
  return std::rotl(block * 0xcc9e2d51U, 15) * 0x1b873593U;
}

// What the object, material or asset is called in a manifest.
std::string name_or(const std::string& name, const char* what, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", what, index + 1) : utf8_name(name);
}

std::string object_name(const Scene& scene, std::size_t index) {
  return name_or(scene.objects[index].name, "object", index);
}

std::string material_name(const Scene& scene, std::size_t index) {
  return name_or(scene.materials[index].name, "material", index);
}

std::string asset_name(const Scene& scene, std::size_t index) {
  const std::string& whole = scene.objects[index].whole;
  return whole.empty() ? object_name(scene, index) : utf8_name(whole);
}

void add_object_ids(const Scene& scene, MatteIds& ids) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    ids.first.push_back(ids.objects.size());
    ids.objects.push_back(matte_id(object_name(scene, i)));
    for (const std::string& part : scene.objects[i].part_names) {
      ids.objects.push_back(matte_id(utf8_name(part)));
    }
  }
}

bool has_unnamed_part(const Object& object) {
  return std::any_of(object.parts.begin(), object.parts.end(),
                     [](const PlacedMesh& part) { return part.name < 0; });
}

// All names of a kind that a picture may show.
std::vector<std::string> names_of(const Scene& scene, MatteKind kind) {
  std::vector<std::string> names;
  if (kind == MatteKind::material) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      names.push_back(material_name(scene, i));
    }
    return names;
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (kind == MatteKind::asset) {
      names.push_back(asset_name(scene, i));
      continue;
    }
    if (has_unnamed_part(object)) names.push_back(object_name(scene, i));
    for (const std::string& part : object.part_names) names.push_back(utf8_name(part));
  }
  return names;
}

std::string manifest(const std::vector<std::string>& names) {
  std::map<std::string, std::string> ids;
  for (const std::string& name : names) ids[name] = fmt::format("{:08x}", matte_id(name));
  return nlohmann::json(ids).dump();
}

bool is_utf8(const std::string& name) {
  try {
    return !nlohmann::json(name).dump().empty();
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

}  // namespace

std::uint32_t murmur3_32(std::string_view bytes) {
  std::uint32_t hash = 0;
  std::size_t done = 0;
  for (; bytes.size() - done >= 4; done += 4) {
    std::uint32_t block = 0;
    for (std::size_t i = 4; i-- > 0;) {
      block = block << 8 | static_cast<unsigned char>(bytes[done + i]);
    }
    hash = std::rotl(hash ^ mixed(block), 13) * 5 + 0xe6546b64U;
  }
  std::uint32_t rest = 0;
  for (std::size_t i = bytes.size(); i-- > done;) {
    rest = rest << 8 | static_cast<unsigned char>(bytes[i]);
  }
  hash ^= mixed(rest) ^ static_cast<std::uint32_t>(bytes.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bU;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35U;
  return hash ^ hash >> 16;
}

std::uint32_t matte_id(std::string_view name) {
  const std::uint32_t hash = murmur3_32(name);
  const std::uint32_t exponent = hash >> 23 & 255U;
  return exponent == 0 || exponent == 255 ? hash ^ 1U << 23 : hash;
}

std::string utf8_name(const std::string& name) {
  if (is_utf8(name)) return name;
  std::string result;
  for (const char c : name) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80) {
      result += c;
    } else {
      result += static_cast<char>(0xc0U | code >> 6);
      result += static_cast<char>(0x80U | (code & 0x3fU));
    }
  }
  return result;
}

MatteIds matte_ids(const Scene& scene) {
  MatteIds ids;
  for (const LayerInfo& layer : matte_layers(scene.output.layers)) {
    if (layer.matte == MatteKind::object) add_object_ids(scene, ids);
    for (std::size_t i = 0; layer.matte == MatteKind::material && i < scene.materials.size(); ++i) {
      ids.materials.push_back(matte_id(material_name(scene, i)));
    }
    for (std::size_t i = 0; layer.matte == MatteKind::asset && i < scene.objects.size(); ++i) {
      ids.assets.push_back(matte_id(asset_name(scene, i)));
    }
  }
  return ids;
}

MatteRanks matte_ranks(std::span<const Cover> covers, double samples) {
  std::array<Cover, MatteRanks().size()> largest;
  const auto end =
      std::partial_sort_copy(covers.begin(), covers.end(), largest.begin(), largest.end(),
                             [](const Cover& a, const Cover& b) {
                               return a.weight > b.weight || (a.weight == b.weight && a.id < b.id);
                             });
  MatteRanks ranks;
  std::transform(largest.begin(), end, ranks.begin(), [samples](const Cover& cover) {
    return MatteRank{std::bit_cast<float>(cover.id), static_cast<float>(cover.weight / samples)};
  });
  return ranks;
}

std::vector<std::string> matte_channels(const std::string& layer) {
  std::vector<std::string> channels;
  for (std::size_t pair = 0; 2 * pair < MatteRanks().size(); ++pair) {
    for (const char channel : {'R', 'G', 'B', 'A'}) {
      channels.push_back(fmt::format("{}{:02}.{}", layer, pair, channel));
    }
  }
  return channels;
}

std::vector<std::pair<std::string, std::string>> cryptomatte_texts(const Scene& scene) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const LayerInfo& layer : matte_layers(scene.output.layers)) {
    const std::string id = fmt::format("{:08x}", matte_id(layer.scene_name)).substr(0, 7);
    const std::string key = "cryptomatte/" + id + "/";
    texts.emplace_back(key + "name", layer.scene_name);
    texts.emplace_back(key + "hash", "MurmurHash3_32");
    texts.emplace_back(key + "conversion", "uint32_to_float32");
    texts.emplace_back(key + "manifest", manifest(names_of(scene, *layer.matte)));
  }
  return texts;
}

}  // namespace restframe
