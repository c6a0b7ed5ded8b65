#include "app/curves.h"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <numbers>

#include "app/commands.h"
#include "physics/doppler.h"
#include "scene/atomic_file.h"

namespace restframe {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

}  // namespace

std::string curves_csv(std::span<const double> speeds, double step) {
  std::string csv = "angle_degrees";
  const auto out = std::back_inserter(csv);
  for (const double speed : speeds) fmt::format_to(out, ",{}c", speed);
  csv += '\n';
  double angle = -90;
  for (int row = 1;; ++row) {
    fmt::format_to(out, "{:.10g}", angle);
    for (const double speed : speeds) {
      fmt::format_to(out, ",{}", blink_rate_factor(speed, angle * std::numbers::pi / 180));
    }
    csv += '\n';
    if (angle == 90) return csv;
    angle = row * step - 90;
    if (angle > 90 - 1e-6 * step) angle = 90;
  }
}

int curves(const CurvesOptions& options) {
  const std::filesystem::path svg = options.output;
  const auto csv = std::filesystem::path(svg).replace_extension(".csv");
  write_text(csv, curves_csv(options.speeds, options.step));
  write_text(svg, curves_svg(options.speeds));
  fmt::print(
      "{}: how many times as fast as it runs a clock is seen to run; the numbers are in {}\n",
      svg.string(), csv.string());
  return 0;
}

}  // namespace restframe
