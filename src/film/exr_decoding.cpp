#include "film/exr_decoding.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>

#include <stdexcept>
#include <vector>

namespace restframe {
namespace {

constexpr std::size_t pixel_bytes = 4;  // the largest of a channel

// Every line of every channel goes to the same place: only whether it can be read counts.
Imf::FrameBuffer one_row(const Imf::Header& header, std::vector<char>& row) {
  const Imath::Box2i& window = header.dataWindow();
  row.resize(pixel_bytes *
             (static_cast<std::size_t>(window.max.x) - static_cast<std::size_t>(window.min.x) + 1));
  Imf::FrameBuffer buffer;
  const Imf::ChannelList& channels = header.channels();
  for (auto i = channels.begin(); i != channels.end(); ++i) {
    const Imf::Channel& channel = i.channel();
    const std::ptrdiff_t first =
        window.min.x / channel.xSampling * static_cast<std::ptrdiff_t>(pixel_bytes);
    buffer.insert(i.name(), Imf::Slice(channel.type, row.data() - first, pixel_bytes, 0,
                                       channel.xSampling, channel.ySampling));
  }
  return buffer;
}

// A block of no bytes decodes as anything.
void check_first_block(Imf::InputPart& part) {
  const Imf::Header& header = part.header();
  if (header.hasType() && Imf::isTiled(header.type())) return;
  const char* pixels = nullptr;
  int size = 0;
  part.rawPixelData(header.dataWindow().min.y, pixels, size);
  if (size <= 0) throw std::runtime_error("an empty block");
}

void decode_part(Imf::MultiPartInputFile& file, int number) {
  if (!file.partComplete(number)) throw std::runtime_error("lines are missing");
  const Imf::Header& header = file.header(number);
  if (header.hasType() && Imf::isDeepData(header.type())) return;  // somebody's, in any case
  Imf::InputPart part(file, number);
  std::vector<char> row;
  part.setFrameBuffer(one_row(header, row));
  // From the bottom: on the way down, OpenEXR takes the next block to be behind the last one, wherever the
  // table says that it is.
  const Imath::Box2i& window = header.dataWindow();
  for (int y = window.max.y; y >= window.min.y; --y) part.readPixels(y);
  check_first_block(part);
}

}  // namespace

bool decodes(const std::filesystem::path& path) {
  try {
    Imf::MultiPartInputFile file(path.c_str(), 0);
    for (int i = 0; i < file.parts(); ++i) decode_part(file, i);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace restframe
