#include "support/exr_writer.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <half.h>

namespace restframe {
namespace {

class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : OStream("memory") {}

  void write(const char text[], int count) override {
    const std::size_t end = position_ + static_cast<std::size_t>(count);
    if (end > bytes.size()) bytes.resize(end);
    std::copy(text, text + count, bytes.begin() + static_cast<std::ptrdiff_t>(position_));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::string bytes;

 private:
  std::size_t position_ = 0;
};

template <class Number>
void write(const ExrText& exr, Imf::PixelType type, Imf::Header& header, MemoryOutput& stream) {
  Imf::FrameBuffer buffer;
  std::vector<std::vector<Number>> values;
  for (const auto& [name, pixels] : exr.channels) {
    values.emplace_back(pixels.begin(), pixels.end());
    header.channels().insert(name, Imf::Channel(type));
    buffer.insert(name,
                  Imf::Slice::Make(type, values.back().data(), header.dataWindow(), sizeof(Number),
                                   sizeof(Number) * static_cast<std::size_t>(exr.width)));
  }
  Imf::OutputFile file(stream, header, 0);
  file.setFrameBuffer(buffer);
  file.writePixels(exr.height);
}

}  // namespace

std::string exr_bytes(const ExrText& exr) {
  const Imath::Box2i display({0, 0}, {exr.width - 1, exr.height - 1});
  const Imath::Box2i data({exr.left, exr.top},
                          {exr.left + exr.width - 1, exr.top + exr.height - 1});
  Imf::Header header(display, data);
  header.compression() = static_cast<Imf::Compression>(exr.compression < Compression::dwaa
                                                           ? static_cast<int>(exr.compression)
                                                           : static_cast<int>(exr.compression) + 2);
  MemoryOutput stream;
  if (exr.half) {
    write<half>(exr, Imf::HALF, header, stream);
  } else {
    write<float>(exr, Imf::FLOAT, header, stream);
  }
  return stream.bytes;
}

std::string sky_exr(int width, int height, const std::function<Vec3f(int x, int y)>& radiance,
                    Compression compression) {
  ExrText exr{width, height, {}, compression};
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<float> values;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) values.push_back(radiance(x, y)[channel]);
    }
    exr.channels.emplace_back(std::string(1, "RGB"[channel]), std::move(values));
  }
  return exr_bytes(exr);
}

}  // namespace restframe
