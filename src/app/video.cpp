#include "app/video.h"

#include <fmt/format.h>

#include "app/child_process.h"
#include "app/picture_files.h"
#include "scene/atomic_file.h"
#include "scene/error.h"
#include "scene/file_names.h"
#include "scene/message.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

constexpr double slowest = 0.01, fastest = 1000;  // pictures a second

}  // namespace

fs::path checked_encoder(const fs::path& video, double rate) {
  if (lower_extension(video) != ".mp4") {
    throw InputError(fmt::format("--video: {} must end in .mp4", quote(video.string())));
  }
  if (rate < slowest || rate > fastest) {
    throw InputError(fmt::format(
        "--video: animation.rate is {} pictures a second, a film takes {} to {}; render without it",
        rate, slowest, fastest));
  }
  const auto encoder = program_on_path("ffmpeg");
  if (!encoder) {
    throw OutputError(
        "--video: ffmpeg is not on the PATH, nothing was rendered; install it (sudo apt-get "
        "install "
        "ffmpeg) or render without --video");
  }
  return *encoder;
}

std::vector<std::string> encoder_arguments(double rate, const fs::path& output) {
  return {"-hide_banner", "-loglevel", "error", "-y",
          // In.
          "-f", "image2pipe", "-framerate", fmt::format("{}", rate), "-c:v", "png", "-i", "pipe:0",
          // Out. Without a codec named, ffmpeg takes H.264 where it can write it. Players expect
          // this matrix of colours.
          "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv",
          "-pix_fmt", "yuv420p", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc",
          "iec61966-2-1", "-color_range", "tv", "-movflags", "+faststart", "-f", "mp4",
          fs::absolute(output).string()};
}

void write_video(const fs::path& video, std::span<const fs::path> pngs, double rate,
                 const fs::path& encoder) {
  AtomicFile file(video);
  std::size_t next = 0;
  const ChildResult result =
      run_child(encoder, encoder_arguments(rate, file.temporary_path()),
                [&] { return next < pngs.size() ? file_content(pngs[next++]) : std::string(); });
  std::error_code error;
  const bool made = fs::file_size(file.temporary_path(), error) > 0 && !error;
  if (!result.succeeded || !made) {
    throw OutputError(fmt::format("{}: ffmpeg failed: {}", video.string(), words_of(result)));
  }
  file.commit();
}

}  // namespace restframe
