#include "film/exr_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfMultiView.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cstring>
#include <span>

#include "film/exr_check.h"
#include "film/exr_header.h"
#include "film/stored_picture.h"
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

  std::span<std::byte> bytes() { return std::as_writable_bytes(std::span(bytes_)); }

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

bool loses_precision(Compression compression) {
  switch (compression) {
    case Compression::none:
    case Compression::rle:
    case Compression::zips:
    case Compression::zip:
    case Compression::piz:
      return false;
    case Compression::pxr24:
    case Compression::dwaa:
    case Compression::dwab:
    case Compression::b44:
    case Compression::b44a:
      break;
  }
  return true;
}

// What a file holds under one header.
struct Part {
  Imf::Header header;
  Imf::FrameBuffer buffer;
};

bool has_channels_of(const Part& part, const std::string& layer) {
  const Imf::ChannelList& channels = part.header.channels();
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    if (std::string_view(channel.name()).starts_with(layer)) return true;
  }
  return false;
}

// A Cryptomatte's attributes belong where its channels are.
void add_texts(Part& part, const PictureInfo& info) {
  constexpr std::string_view all = "cryptomatte/", name = "/name";
  std::vector<std::string_view> elsewhere;  // "cryptomatte/1a2b3c4/"
  for (const auto& [key, text] : info.texts) {
    if (!key.starts_with(all) || !key.ends_with(name) || has_channels_of(part, text)) continue;
    elsewhere.push_back(std::string_view(key).substr(0, key.size() - name.size() + 1));
  }
  for (const auto& text : info.texts) {
    const bool dropped =
        std::any_of(elsewhere.begin(), elsewhere.end(),
                    [&text](std::string_view of) { return text.first.starts_with(of); });
    if (!dropped) part.header.insert(text.first, Imf::StringAttribute(text.second));
  }
}

void add_channel(Part& part, const std::string& name, const StoredChannel& channel) {
  const Imath::Box2i& window = part.header.dataWindow();
  const auto columns = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  part.header.channels().insert(name, Imf::Channel(channel.type));
  part.buffer.insert(name, Imf::Slice::Make(channel.type, channel.pixels, window, channel.stride,
                                            channel.stride * columns));
}

struct FileContent {
  const StoredPicture& stored;
  const PictureInfo& info;
  PixelWindow window;

  bool has(bool light) const {
    return std::any_of(stored.channels().begin(), stored.channels().end(),
                       [&](const StoredChannel& c) { return is_light(c.layer) == light; });
  }
};

// All channels; of several views, by names that tell them apart.
Part whole_part(const FileContent& content, Compression compression) {
  const auto& [stored, info, window] = content;
  const bool several = !info.views.empty();
  const CameraPose& pose = several ? info.views[0].pose : info.pose;
  Part part{exr_header(window, info, pose, stored.time_origins()), {}};
  set_compression(part.header, compression, info.compression_level);
  if (several) add_views(part.header, window, info);
  for (const StoredChannel& channel : stored.channels()) {
    const int view = static_cast<int>(channel.view);
    add_channel(part,
                several ? Imf::insertViewName(channel.name, Imf::multiView(part.header), view)
                        : channel.name,
                channel);
  }
  return part;
}

// The channels of one view that are light, or that are data.
Part partial_part(const FileContent& content, bool light, std::size_t view) {
  const auto& [stored, info, window] = content;
  const bool several = !info.views.empty();
  const CameraPose& pose = several ? info.views[view].pose : info.pose;
  Part part{exr_header(window, info, pose, stored.time_origins()), {}};
  set_compression(part.header, light ? info.compression : Compression::zip, info.compression_level);
  const std::string name = light ? "light" : "data";
  part.header.setType(Imf::SCANLINEIMAGE);
  part.header.setName(several ? info.views[view].name + "." + name : name);
  if (several) part.header.setView(info.views[view].name);
  for (const StoredChannel& channel : stored.channels()) {
    if (channel.view != view || is_light(channel.layer) != light) continue;
    add_channel(part, channel.name, channel);
  }
  return part;
}

std::vector<Part> parts_of(const FileContent& content) {
  const bool lossy = loses_precision(content.info.compression);
  if (lossy && !content.has(true)) return {whole_part(content, Compression::zip)};
  if (!lossy || !content.has(false)) return {whole_part(content, content.info.compression)};
  std::vector<Part> parts;
  for (const bool light : {true, false}) {
    for (std::size_t view = 0; view < std::max<std::size_t>(content.info.views.size(), 1); ++view) {
      parts.push_back(partial_part(content, light, view));
    }
  }
  return parts;
}

void encode(const FileContent& content, MemoryStream& stream) {
  std::vector<Part> parts = parts_of(content);
  for (Part& part : parts) add_texts(part, content.info);
  if (parts.size() == 1) {
    Imf::OutputFile file(stream, parts[0].header);
    file.setFrameBuffer(parts[0].buffer);
    file.writePixels(content.window.height);
    return;
  }
  std::vector<Imf::Header> headers;
  headers.reserve(parts.size());
  for (const Part& part : parts) headers.push_back(part.header);
  const int count = static_cast<int>(parts.size());
  Imf::MultiPartOutputFile file(stream, headers.data(), count);
  for (int i = 0; i < count; ++i) {
    Imf::OutputPart part(file, i);
    part.setFrameBuffer(parts[static_cast<std::size_t>(i)].buffer);
    part.writePixels(content.window.height);
  }
}

// OpenEXR calls a file complete that knows where all its pixels should be; the last ones must be there,
// too.
bool is_complete(Imf::MultiPartInputFile& file) {
  for (int i = 0; i < file.parts(); ++i) {
    if (!file.partComplete(i)) return false;
    Imf::InputPart part(file, i);
    const char* pixels = nullptr;
    int size = 0;
    part.rawPixelData(part.header().dataWindow().max.y, pixels, size);
  }
  return true;
}

}  // namespace

WriteReport write_exr(const std::filesystem::path& path, std::span<const Picture> views,
                      const PictureInfo& info) {
  WriteReport report;
  MemoryStream stream;
  try {
    const StoredPicture stored(views, info);
    report = stored.report();
    encode({stored, info, views.front().window()}, stream);
    MemoryInput input(stream.bytes());
    Imf::MultiPartInputFile file(input);
    if (!is_complete(file)) throw OutputError("the picture is not complete");
    seal_exr(stream.bytes());
  } catch (const std::exception& error) {
    throw OutputError(path.string() + ": " + error.what());
  }
  write_file_atomically(path, stream.bytes());
  return report;
}

}  // namespace restframe
