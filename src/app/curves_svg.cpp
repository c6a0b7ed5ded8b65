// The drawing of `restframe curves`. All lengths are in the drawing's own units, y downwards:
//
//     +--------------------------------------+
//     | factor at -90              legend    |
//     |\                                     |
//     | \   cross-over angles | pure dilation|
//     |..\.o..o......o........|..............|  alpha = 1
//     |                       |              |
//     +--------------------------------------+
//    -90                      0             90

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>
#include <vector>

#include "app/curves.h"
#include "physics/doppler.h"

namespace restframe {
namespace {

constexpr double width = 920, height = 600;
constexpr double left = 78, right = 896, top = 58, bottom = 530;
constexpr double line_height = 17;

struct Curve {
  double speed;
  std::string_view color;
};

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

double factor(const Curve& curve, double degrees) {
  return blink_rate_factor(curve.speed, radians(degrees));
}

std::string_view paper_color(double speed) {
  if (speed == 0.99) return "#c8141e";
  if (speed == 0.9) return "#21873b";
  if (speed == 0.85) return "#8a5a2b";
  return {};
}

// The paper's colours for the paper's speeds; other speeds take what is left.
std::vector<Curve> coloured(std::span<const double> speeds) {
  std::vector<std::string_view> left_over = {"#1f5fb4", "#7a3fa0", "#d97706", "#0f8b8d",
                                             "#4a4a4a", "#8a5a2b", "#21873b", "#c8141e"};
  for (const double speed : speeds) std::erase(left_over, paper_color(speed));
  std::vector<Curve> curves;
  auto next = left_over.begin();
  for (const double speed : speeds) {
    const std::string_view own = paper_color(speed);
    curves.push_back({speed, own.empty() ? *next++ : own});
  }
  std::sort(curves.begin(), curves.end(),
            [](const Curve& a, const Curve& b) { return a.speed > b.speed; });
  return curves;
}

// 1, 2 or 5 times a power of ten, such that about eight of them reach `largest`.
double tick_for(double largest) {
  const double power = std::pow(10.0, std::floor(std::log10(largest / 8)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= largest / 8) return digit * power;
  }
  return 10 * power;
}

std::string degrees_text(double degrees, int decimals) {
  const std::string size = fmt::format("{:.{}f}", std::abs(degrees), decimals);
  return (degrees < 0 ? "\u2212" : "") + size + "\u00b0";
}

class Drawing {
 public:
  explicit Drawing(std::vector<Curve> curves) : curves_(std::move(curves)) {
    const double largest = std::max(1.0, factor(curves_.front(), -90));
    tick_ = tick_for(largest);
    most_ = tick_ * std::ceil(1.02 * largest / tick_);
  }

  std::string svg() {
    head();
    axes();
    for (const Curve& curve : curves_) path(curve);
    approaching();
    crossovers();
    dilations();
    legend();
    return text_ + "</svg>\n";
  }

 private:
  static double x(double degrees) { return left + (degrees + 90) / 180 * (right - left); }
  double y(double alpha) const { return bottom - alpha / most_ * (bottom - top); }

  template <class... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
    text_ += '\n';
  }
  void line(double x1, double y1, double x2, double y2, std::string_view style) {
    add(R"(<line x1="{:.2f}" y1="{:.2f}" x2="{:.2f}" y2="{:.2f}" {}/>)", x1, y1, x2, y2, style);
  }
  void word(double at_x, double at_y, std::string_view style, std::string_view word) {
    add(R"(<text x="{:.2f}" y="{:.2f}" {}>{}</text>)", at_x, at_y, style, word);
  }
  void mark(const Curve& curve, double degrees) {
    add(R"(<circle cx="{:.2f}" cy="{:.2f}" r="3.2" fill="#fff" stroke="{}" stroke-width="1.6"/>)",
        x(degrees), y(factor(curve, degrees)), curve.color);
  }
  // With a white rim, so that no line strikes it through.
  static std::string fill(const Curve& curve) {
    return fmt::format(R"(fill="{}" stroke="#fff" stroke-width="4" paint-order="stroke")",
                       curve.color);
  }

  void head() {
    add(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )"
        R"(font-family="Helvetica, Arial, sans-serif" font-size="14" fill="#222">)",
        width, height);
    add("<title>Viewed frequency variation factor versus viewing direction</title>");
    add("<desc>How many times as fast as it runs a moving clock is seen to run, from approaching "
        "(\u221290\u00b0) to receding (90\u00b0)</desc>");
    add(R"(<rect width="{}" height="{}" fill="#fff"/>)", width, height);
    word(left, 34, R"(font-size="17")",
         "How fast a moving clock is <tspan font-style=\"italic\">seen</tspan> to run: "
         "\u03b1 = 1 / ((1 + e\u00b7\u03b2) \u03b3)");
  }

  void axes() {
    for (int degrees = -90; degrees <= 90; degrees += 15) {
      line(x(degrees), top, x(degrees), bottom, R"(stroke="#e8e8e8")");
      line(x(degrees), bottom, x(degrees), bottom + 5, R"(stroke="#222")");
      word(x(degrees), bottom + 21, R"(text-anchor="middle")", degrees_text(degrees, 0));
    }
    const int ticks = static_cast<int>(std::lround(most_ / tick_));
    for (int i = 0; i <= ticks; ++i) {
      line(left, y(i * tick_), right, y(i * tick_), R"(stroke="#e8e8e8")");
      line(left - 5, y(i * tick_), left, y(i * tick_), R"(stroke="#222")");
      word(left - 9, y(i * tick_) + 5, R"(text-anchor="end")", fmt::format("{:.6g}", i * tick_));
    }
    add(R"(<path d="M{0} {1}V{2}H{3}" fill="none" stroke="#222"/>)", left, top, bottom, right);
    word((left + right) / 2, bottom + 44, R"(text-anchor="middle")", "viewing direction");
    word(left, bottom + 44, R"(fill="#666")", "approaching");
    word(right, bottom + 44, R"(text-anchor="end" fill="#666")", "receding");
    add(R"-(<text text-anchor="middle" transform="translate(22 {:.2f}) rotate(-90)">)-"
        "observed over proper frequency, \u03b1</text>",
        (top + bottom) / 2);
  }

  // Its points crowd towards -90 degrees, where fast objects' curves are steep.
  void path(const Curve& curve) {
    constexpr int pieces = 240;
    std::string points;
    for (int i = 0; i <= pieces; ++i) {
      const double part = static_cast<double>(i) / pieces;
      const double degrees = -90 + 180 * part * part;
      fmt::format_to(std::back_inserter(points), "{}{:.2f} {:.2f}", i == 0 ? "M" : "L", x(degrees),
                     y(factor(curve, degrees)));
    }
    add(R"(<path d="{}" fill="none" stroke="{}" stroke-width="2.2" stroke-linejoin="round"/>)",
        points, curve.color);
  }

  // Where labels would lie on one another, those of the slower objects are left out.
  void approaching() {
    double last = 0;  // the label before
    for (const Curve& curve : curves_) {
      mark(curve, -90);
      const double label = y(factor(curve, -90)) - 5;
      if (label < last + line_height) continue;
      word(left + 9, label, fill(curve), fmt::format("{:.3g}", factor(curve, -90)));
      last = label;
    }
  }

  // Faster objects cross over earlier, further to the left: their labels are higher.
  void crossovers() {
    line(left, y(1), right, y(1), R"(stroke="#222" stroke-dasharray="5 4")");
    word(right, y(1) - 7, R"(text-anchor="end")", "\u03b1 = 1: seen to run as it does");
    double label = y(1) - 30;
    for (auto curve = curves_.rbegin(); curve != curves_.rend(); ++curve) {
      if (curve->speed == 0) continue;
      const double degrees = crossover_angle(curve->speed) * 180 / std::numbers::pi;
      line(x(degrees), y(1), x(degrees), label - 10, fmt::format(R"(stroke="{}")", curve->color));
      word(x(degrees) + 5, label, fill(*curve), degrees_text(degrees, 1));
      mark(*curve, degrees);
      label -= line_height;
    }
    if (curves_.front().speed == 0) return;
    const double first = crossover_angle(curves_.front().speed) * 180 / std::numbers::pi;
    word(x(first) + 5, label, R"(fill="#444")", "cross-over angles:");
  }

  void dilations() {
    line(x(0), top, x(0), bottom, R"(stroke="#888" stroke-dasharray="2 3")");
    const double first = y(1) - 30 - line_height * static_cast<double>(curves_.size());
    word(x(12), first, R"(fill="#444")", "\u201cpure\u201d time dilation, 1/\u03b3, at 0\u00b0:");
    double label = first;
    for (const Curve& curve : curves_) {
      label += line_height;
      word(x(12), label, fill(curve), fmt::format("{:.3g} at {}c", factor(curve, 0), curve.speed));
      mark(curve, 0);
    }
  }

  void legend() {
    double at = top + 22;
    for (const Curve& curve : curves_) {
      line(right - 110, at - 5, right - 76, at - 5,
           fmt::format(R"(stroke="{}" stroke-width="2.2")", curve.color));
      word(right - 68, at, "", fmt::format("{}c", curve.speed));
      at += line_height + 3;
    }
  }

  std::vector<Curve> curves_;   // the fastest first
  double tick_ = 1, most_ = 1;  // of the vertical axis
  std::string text_;
};

}  // namespace

std::string curves_svg(std::span<const double> speeds) {
  return Drawing(coloured(speeds)).svg();
}

}  // namespace restframe
