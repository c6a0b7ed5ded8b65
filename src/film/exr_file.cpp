#include "film/exr_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "film/exr_header.h"
#include "scene/atomic_file.h"
#include "scene/error.h"

namespace restframe {
namespace {

// OpenEXR can report success on a full disk: the write fails in a destructor. So it writes to
// memory, and the file is written where every step is checked.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : OStream("memory") {}

  void write(const char bytes[], int count) override {
    const std::size_t end = position_ + static_cast<std::size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, bytes, static_cast<std::size_t>(count));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::span<const std::byte> bytes() const { return std::as_bytes(std::span(bytes_)); }

 private:
  std::vector<char> bytes_;
  std::size_t position_ = 0;
};

class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(std::span<const std::byte> bytes) : IStream("memory"), bytes_(bytes) {}

  bool read(char to[], int count) override {
    if (position_ + static_cast<std::size_t>(count) > bytes_.size()) {
      throw OutputError("the picture ends too early");
    }
    std::memcpy(to, bytes_.data() + position_, static_cast<std::size_t>(count));
    position_ += static_cast<std::size_t>(count);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

// Floats keep blink phases up to here; beyond, an origin is taken off.
constexpr double longest_float_time = 1024.0;

double time_origin(const Picture& picture, ChannelKind kind) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Plane& plane : picture.planes()) {
    if (plane.kind != kind) continue;
    for (const double t : plane.times) {
      if (std::isnan(t)) continue;
      least = std::min(least, t);
      most = std::max(most, t);
    }
  }
  const bool small = std::max(std::abs(least), std::abs(most)) <= longest_float_time;
  return least > most || small ? 0.0 : std::floor(least);
}

std::vector<float> float_times(const std::vector<double>& times, double origin) {
  std::vector<float> result(times.size());
  std::transform(times.begin(), times.end(), result.begin(), [origin](double t) {
    return std::isnan(t) ? 0.0F : static_cast<float>(t - origin);
  });
  return result;
}

// The beauty in the type in which it is stored, within that type's range.
template <class Stored>
std::vector<Stored> stored_beauty(const Picture& picture, float largest, std::size_t& changed) {
  std::vector<Stored> result;
  result.reserve(4 * picture.rgba().size());
  for (const Vec4f& pixel : picture.rgba()) {
    for (int i = 0; i < 4; ++i) {
      const float value = std::isnan(pixel[i]) ? 0.0F : glm::clamp(pixel[i], -largest, largest);
      if (value != pixel[i]) ++changed;
      result.emplace_back(value);
    }
  }
  return result;
}

constexpr const char* beauty_channels[4] = {"R", "G", "B", "A"};

void add_channel(Imf::Header& header, Imf::FrameBuffer& buffer, const char* name,
                 Imf::PixelType type, const void* pixels, std::size_t stride) {
  const Imath::Box2i& window = header.dataWindow();
  const auto columns = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  header.channels().insert(name, Imf::Channel(type));
  buffer.insert(name, Imf::Slice::Make(type, pixels, window, stride, stride * columns));
}

template <class Stored>
void add_beauty(Imf::Header& header, Imf::FrameBuffer& buffer, Imf::PixelType type,
                const std::vector<Stored>& rgba) {
  for (std::size_t i = 0; i < 4; ++i) {
    add_channel(header, buffer, beauty_channels[i], type, &rgba[i], 4 * sizeof(Stored));
  }
}

void encode(const Picture& picture, const PictureInfo& info, MemoryStream& stream,
            WriteReport& report) {
  const std::pair origins{time_origin(picture, ChannelKind::time_proper),
                          time_origin(picture, ChannelKind::time_world)};
  Imf::Header header = exr_header(picture, info, origins);
  Imf::FrameBuffer buffer;
  std::vector<half> halves;
  std::vector<float> floats;
  if (picture.has_beauty() && info.float_beauty) {
    floats = stored_beauty<float>(picture, std::numeric_limits<float>::max(), report.clamped);
    add_beauty(header, buffer, Imf::FLOAT, floats);
  } else if (picture.has_beauty()) {
    halves = stored_beauty<half>(picture, HALF_MAX, report.clamped);
    add_beauty(header, buffer, Imf::HALF, halves);
  }
  std::vector<std::vector<float>> times;
  times.reserve(picture.planes().size());
  for (const Plane& plane : picture.planes()) {
    const float* values = plane.values.data();
    if (plane.kind != ChannelKind::plain) {
      const bool proper = plane.kind == ChannelKind::time_proper;
      times.push_back(float_times(plane.times, proper ? origins.first : origins.second));
      values = times.back().data();
    }
    add_channel(header, buffer, plane.name.c_str(), Imf::FLOAT, values, sizeof(float));
  }
  Imf::OutputFile file(stream, header);
  file.setFrameBuffer(buffer);
  file.writePixels(picture.height());
}

}  // namespace

WriteReport write_exr(const std::filesystem::path& path, const Picture& picture,
                      const PictureInfo& info) {
  WriteReport report;
  MemoryStream stream;
  try {
    encode(picture, info, stream, report);
    MemoryInput input(stream.bytes());
    if (!Imf::InputFile(input).isComplete()) throw OutputError("the picture is not complete");
  } catch (const std::exception& error) {
    throw OutputError(path.string() + ": " + error.what());
  }
  write_file_atomically(path, stream.bytes());
  return report;
}

std::string exr_text(const std::filesystem::path& path, const std::string& name) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  try {
    Imf::InputFile file(path.c_str());
    const auto* text = file.header().findTypedAttribute<Imf::StringAttribute>(name);
    if (text == nullptr || !file.isComplete()) return {};
    // OpenEXR calls a file complete that knows where all its pixels should be; the last ones must
    // be there, too.
    const char* pixels = nullptr;
    int size = 0;
    file.rawPixelData(file.header().dataWindow().max.y, pixels, size);
    return text->value();
  } catch (const std::exception&) {
    return {};  // torn or of another kind: to the caller as good as not there
  }
}

}  // namespace restframe
