#include "support/exr_reader.h"

#include <ImfBoxAttribute.h>
#include <ImfChannelList.h>
#include <ImfCompressionAttribute.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRationalAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfStringVectorAttribute.h>
#include <ImfTimeCodeAttribute.h>
#include <ImfVecAttribute.h>
#include <fmt/format.h>

#include <array>
#include <sstream>
#include <stdexcept>

namespace restframe {
namespace {

template <class Number>
std::string list_text(const Number* values, int count) {
  return fmt::format("{}", fmt::join(values, values + count, " "));
}

std::string text_of(const std::string& value) {
  return value;
}
std::string text_of(int value) {
  return fmt::format("{}", value);
}
std::string text_of(float value) {
  return fmt::format("{}", value);
}
std::string text_of(double value) {
  return fmt::format("{}", value);
}
std::string text_of(const Imf::Rational& r) {
  return fmt::format("{}/{}", r.n, r.d);
}
std::string text_of(const Imf::TimeCode& t) {
  return fmt::format("{:02}:{:02}:{:02}:{:02}", t.hours(), t.minutes(), t.seconds(), t.frame());
}
std::string text_of(const Imath::Box2i& b) {
  return fmt::format("{} {} {} {}", b.min.x, b.min.y, b.max.x, b.max.y);
}
template <class T>
std::string text_of(const Imath::Vec2<T>& v) {
  return list_text(&v.x, 2);
}
template <class T>
std::string text_of(const Imath::Vec3<T>& v) {
  return list_text(&v.x, 3);
}
template <class T>
std::string text_of(const Imath::Matrix44<T>& m) {
  return list_text(&m.x[0][0], 16);
}
std::string text_of(const Imf::StringVector& lines) {
  return fmt::format("{}", fmt::join(lines, "\n"));
}
std::string text_of(Imf::Compression compression) {
  constexpr std::array names = {"none",  "rle", "zips", "zip",  "piz",
                                "pxr24", "b44", "b44a", "dwaa", "dwab"};
  const auto index = static_cast<std::size_t>(compression);
  return index < names.size() ? names[index] : "unknown";
}

template <class T>
bool describe(const Imf::Attribute& attribute, std::string& text) {
  const auto* typed = dynamic_cast<const Imf::TypedAttribute<T>*>(&attribute);
  if (typed) text = text_of(typed->value());
  return typed != nullptr;
}

template <class... Types>
std::string description(const Imf::Attribute& attribute) {
  std::string text;
  if ((describe<Types>(attribute, text) || ...)) return text;
  return fmt::format("({})", attribute.typeName());
}

std::string text_of_attribute(const Imf::Attribute& attribute) {
  return description<std::string, int, float, double, Imf::Rational, Imath::Box2i, Imath::V2i,
                     Imath::V2f, Imath::V2d, Imath::V3i, Imath::V3f, Imath::V3d, Imath::M44f,
                     Imath::M44d, Imf::StringVector, Imf::Compression, Imf::TimeCode>(attribute);
}

// OpenEXR wants the address that the pixel (0, 0) would have, which may lie outside the data.
void read_channels(Imf::InputPart& file, const Imath::Box2i& window, ExrPicture& picture) {
  const std::size_t pixels =
      static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  const std::size_t row = sizeof(float) * static_cast<std::size_t>(picture.width);
  Imf::FrameBuffer buffer;
  const Imf::ChannelList& channels = file.header().channels();
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    std::vector<float>& values = picture.channels[channel.name()];
    values.resize(pixels);
    const Imf::PixelType type = channel.channel().type;
    picture.types[channel.name()] = type == Imf::HALF    ? "half"
                                    : type == Imf::FLOAT ? "float"
                                                         : "integer";
    buffer.insert(channel.name(),
                  Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float), row));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
}

}  // namespace

const std::vector<float>& ExrPicture::channel(const std::string& name) const {
  const auto found = channels.find(name);
  if (found != channels.end()) return found->second;
  std::string there;
  for (const auto& [other, values] : channels) there += " " + other;
  throw std::runtime_error("no channel " + name + " among" + there);
}

float ExrPicture::at(const std::string& name, int x, int y) const {
  if (x < 0 || y < 0 || x >= width || y >= height) throw std::runtime_error("outside the picture");
  const int index = y * width + x;
  return channel(name)[static_cast<std::size_t>(index)];
}

ExrPicture read_exr(const std::filesystem::path& path) {
  std::vector<ExrPicture> parts = read_exr_parts(path);
  if (parts.size() == 1) return std::move(parts[0]);
  throw std::runtime_error(fmt::format("{}: has {} parts", path.string(), parts.size()));
}

std::vector<ExrPicture> read_exr_parts(const std::filesystem::path& path) {
  try {
    Imf::MultiPartInputFile file(path.c_str());
    std::vector<ExrPicture> parts;
    for (int i = 0; i < file.parts(); ++i) {
      if (!file.partComplete(i)) throw std::runtime_error("incomplete");
      Imf::InputPart part(file, i);
      const Imath::Box2i window = part.header().dataWindow();
      ExrPicture& picture = parts.emplace_back();
      picture.width = window.max.x - window.min.x + 1;
      picture.height = window.max.y - window.min.y + 1;
      for (auto entry = part.header().begin(); entry != part.header().end(); ++entry) {
        picture.attributes[entry.name()] = text_of_attribute(entry.attribute());
      }
      read_channels(part, window, picture);
    }
    return parts;
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

std::pair<double, double> time_origins(const ExrPicture& picture) {
  std::istringstream text(picture.attributes.at("timeOrigin"));
  double proper = 0, world = 0;
  text >> proper >> world;
  return {proper, world};
}

}  // namespace restframe
