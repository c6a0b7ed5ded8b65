#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace restframe {

// Throws InputError unless the name ends in .mp4 and the rate (pictures a second) suits a film, and
// OutputError where ffmpeg is not installed. Returns where ffmpeg is.
std::filesystem::path checked_encoder(const std::filesystem::path& video, double rate);

// What ffmpeg is told: PNGs come one after the other through its standard input; odd sizes grow by
// a pixel, since four pixels share a colour.
std::vector<std::string> encoder_arguments(double rate, const std::filesystem::path& output);

// A film of the PNGs in this order, whole under its name or not at all. Throws OutputError with
// what ffmpeg said, and Interrupted.
void write_video(const std::filesystem::path& video, std::span<const std::filesystem::path> pngs,
                 double rate, const std::filesystem::path& encoder);

}  // namespace restframe
