#include "importers/obj_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "importers/asset_file.h"
#include "importers/input_file.h"
#include "scene/error.h"
#include "scene/file_names.h"
#include "scene/message.h"

namespace restframe {
namespace {

using Bytes = std::vector<std::uint8_t>;

// The channel of a map that is a number each pixel.
ChannelSource scalar(const MtlMap& map, const std::string& file, char automatic) {
  const char channel = map.channel == 0 || map.channel == 'z' ? automatic : map.channel;
  return {file, channel, map.base, map.gain};
}

// Red, green and blue, or one channel as grey where the map picks one.
ChannelSources colors(const MtlMap& map, const std::string& file) {
  ChannelSources result;
  const char* channels = "rgb";
  for (std::size_t i = 0; i < 3; ++i) result[i] = scalar(map, file, channels[i]);
  return result;
}

// Just the image, unchanged.
ChannelSources whole(const std::string& file) {
  ChannelSources result;
  const char* channels = "rgba";
  for (std::size_t i = 0; i < 4; ++i) result[i] = {file, channels[i], 0, 1};
  return result;
}

// Most normals point out of the surface: blue.
bool looks_like_normals(const Image& image) {
  std::array<std::uint64_t, 3> sum{};
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += image.rgba[i + c];
  }
  const std::uint64_t pixels = std::max<std::uint64_t>(image.rgba.size() / 4, 1);
  const auto is_middle = [&](std::uint64_t s) { return s / pixels > 96 && s / pixels < 160; };
  return is_middle(sum[0]) && is_middle(sum[1]) && sum[2] / pixels > 180;
}

// As the format has it, v upwards, told of ours, which is 1 - v.
UvTransform transform_of(const MtlMap& map) {
  UvTransform result;
  result.along_u = {map.scale.x, 0};
  result.along_v = {0, map.scale.y};
  result.offset = {map.offset.x, 1 - map.scale.y - map.offset.y};
  return result;
}

bool begins(const Bytes& bytes, std::initializer_list<std::uint8_t> start) {
  return bytes.size() >= start.size() && std::equal(start.begin(), start.end(), bytes.begin());
}

}  // namespace

void ObjTextures::apply(const MtlMaterial& source, Material& material) {
  apply_color(source, material);
  apply_emission(source, material);
  apply_metallic_roughness(source, material);
  apply_normal(source, material);
  apply_layers(source, material);
}

// map_d becomes the alpha of map_Kd.
void ObjTextures::apply_color(const MtlMaterial& source, Material& material) {
  const std::optional<Found> color = find(source, "kd"), opacity = find(source, "d");
  if (!color && !opacity) return;
  ChannelSources sources;
  if (color) sources = colors(*color->map, color->file);
  // The colour's own image is opaque where it has no alpha, not where it is bright.
  const bool is_same = color && opacity && color->file == opacity->file;
  if (opacity) sources[3] = scalar(*opacity->map, opacity->file, is_same ? 'a' : 'm');
  material.base_color_texture = use(sources, color ? *color->map : *opacity->map, true);
  if (color && opacity) check_options(source, *color->map, *opacity->map);
  if (opacity) material.alpha_mode = AlphaMode::blend;
  if (!color) return;
  const auto kd = source.colors.find("kd");
  if (kd == source.colors.end()) {
    material.base_color.value = Vec3f(1);
  } else if (kd->second == Vec3f(0)) {
    warn(source, color->map->key, "Kd is black and would hide it, white is used");
    material.base_color.value = Vec3f(1);
  }
}

void ObjTextures::apply_emission(const MtlMaterial& source, Material& material) {
  const std::optional<Found> emission = find(source, "ke");
  if (!emission) return;
  material.emission_texture = use(colors(*emission->map, emission->file), *emission->map, true);
  if (!source.colors.count("ke")) material.emission.value = Vec3f(1);
}

// glTF keeps roughness in green and the metal's share in blue.
void ObjTextures::apply_metallic_roughness(const MtlMaterial& source, Material& material) {
  const std::optional<Found> roughness = find(source, "pr"), metallic = find(source, "pm");
  if (!roughness && !metallic) return;
  if (roughness && metallic) check_options(source, *roughness->map, *metallic->map);
  ChannelSources sources;
  if (roughness) sources[1] = scalar(*roughness->map, roughness->file, 'l');
  if (metallic) sources[2] = scalar(*metallic->map, metallic->file, 'l');
  material.metallic_roughness_texture =
      use(sources, roughness ? *roughness->map : *metallic->map, false);
  if (roughness && !source.numbers.count("pr")) material.roughness.value = 1;
  if (metallic && !source.numbers.count("pm")) material.metallic.value = 1;
}

// Programs name normal maps as bump maps, too; these are told by their colour. Heights are not used.
void ObjTextures::apply_normal(const MtlMaterial& source, Material& material) {
  std::optional<Found> normal = find(source, "norm");
  const std::optional<Found> bump = find(source, "bump");
  if (bump && !normal && looks_like_normals(decode(bump->file))) normal = bump;
  if (bump && !normal)
    warn(source, bump->map->key, "a height map, not used; norm names normal maps");
  if (!normal) return;
  material.normal_texture = use(whole(normal->file), *normal->map, false);
  material.normal_scale.value = normal->map->multiplier;
}

void ObjTextures::apply_layers(const MtlMaterial& source, Material& material) {
  if (const auto specular = find(source, "ks")) {
    material.specular_color_texture =
        use(colors(*specular->map, specular->file), *specular->map, true);
  }
  if (const auto sheen = find(source, "ps")) {
    material.sheen_color_texture = use(colors(*sheen->map, sheen->file), *sheen->map, true);
  }
  apply_scalar(source, "pc", 0, material.clearcoat_texture);
  if (material.clearcoat_texture.texture >= 0 && !source.numbers.count("pc")) {
    material.clearcoat.value = 1;
  }
  apply_scalar(source, "pcr", 1, material.clearcoat_roughness_texture);
  if (material.clearcoat_roughness_texture.texture >= 0 && !source.numbers.count("pcr")) {
    material.clearcoat_roughness.value = 1;
  }
}

void ObjTextures::apply_scalar(const MtlMaterial& source, const char* what, std::size_t channel,
                               TextureUse& texture) {
  const std::optional<Found> found = find(source, what);
  if (!found) return;
  ChannelSources sources;
  sources[channel] = scalar(*found->map, found->file, 'l');
  texture = use(sources, *found->map, false);
}

// Two pictures that become one have their place in common.
void ObjTextures::check_options(const MtlMaterial& source, const MtlMap& used,
                                const MtlMap& other) {
  if (used.offset == other.offset && used.scale == other.scale && used.clamp == other.clamp) return;
  warn(source, other.key, fmt::format("is placed by the options of {}", used.key));
}

std::optional<ObjTextures::Found> ObjTextures::find(const MtlMaterial& source, const char* what) {
  const auto given = source.maps.find(what);
  if (given == source.maps.end()) return std::nullopt;
  const MtlMap& map = given->second;
  if (map.file.empty()) {
    warn(source, map.key, "names no file, not used");
    return std::nullopt;
  }
  const std::string at = fmt::format("{}: material {}: {}: {}", source.file.string(),
                                     quote(source.name), map.key, quote(map.file));
  const std::optional<Path> file = find_asset_file(root_, folder_of(source.file), map.file, at);
  if (!file) {
    warn(source, map.key, fmt::format("image {} does not exist, not used", quote(map.file)));
  } else if (!is_picture(file->string())) {
    warn(source, map.key,
         fmt::format("image {} is neither PNG nor JPEG, not used", quote(map.file)));
  } else {
    return Found{&map, file->string()};
  }
  return std::nullopt;
}

// What says by its name to be one is decoded, and refused if it is none.
bool ObjTextures::is_picture(const std::string& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".png" || extension == ".jpg" || extension == ".jpeg") return true;
  InputFile opened(file, file);
  Bytes start(std::min<std::size_t>(opened.size(), 4), 0);
  opened.read(start.data(), start.size());
  return begins(start, {0x89, 'P', 'N', 'G'}) || begins(start, {0xFF, 0xD8, 0xFF});
}

TextureUse ObjTextures::use(const ChannelSources& sources, const MtlMap& map, bool srgb) {
  const auto next = static_cast<int>(asset_.textures.size());
  const auto [entry, is_new] =
      textures_.try_emplace(std::tuple(image(sources), srgb, map.clamp, map.smooth), next);
  if (is_new) {
    Texture texture;
    texture.image = std::get<0>(entry->first);
    texture.srgb = srgb;
    if (map.clamp) texture.wrap_u = texture.wrap_v = Wrap::clamp;
    if (!map.smooth) texture.filter = TextureFilter::nearest;
    asset_.textures.push_back(texture);
  }
  return {entry->second, 0, transform_of(map)};
}

// An image that is taken as it is gets decoded once, whatever its alpha is used for.
int ObjTextures::image(const ChannelSources& sources) {
  const std::string& file = sources[0].file;
  ChannelSources key = sources;
  const ChannelSources plain = whole(file);
  const bool is_plain = !file.empty() && std::equal(key.begin(), key.begin() + 3, plain.begin()) &&
                        (key[3].file.empty() || key[3] == plain[3]);
  if (is_plain) key = plain;
  const auto known = images_.find(key);
  if (known != images_.end()) return known->second;
  const auto decoded = [this](const std::string& name) { return decode(name); };
  asset_.images.push_back(is_plain ? decode(file) : mix_image(key, limits_, decoded));
  bytes_ += asset_.images.back().rgba.size();
  if (bytes_ > limits_.total_bytes) {
    throw InputError(fmt::format("{}: all images need more than {} bytes, the limit", file,
                                 limits_.total_bytes));
  }
  const auto index = static_cast<int>(asset_.images.size()) - 1;
  images_.emplace(key, index);
  return index;
}

Image ObjTextures::decode(const std::string& file) {
  const auto bytes = read_input_file<Bytes>(file, limits_.total_bytes, file);
  asset_.files.insert(file);
  Image image = decode_image(bytes, file, limits_);
  image.name = Path(file).filename().string();
  return image;
}

void ObjTextures::warn(const MtlMaterial& source, const std::string& key, const std::string& what) {
  warnings_.push_back(
      fmt::format("{}: material {}: {}: {}", source.file.string(), quote(source.name), key, what));
}

}  // namespace restframe
