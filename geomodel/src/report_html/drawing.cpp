// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace geomesh::geomodel::page {

namespace {

constexpr double picture_width = 760, margin_left = 70, margin_bottom = 40, margin_top = 12, margin_right = 16;

std::string pixels(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

/// From the section's coordinates to those of the picture, y downwards.
struct Frame {
  Vec2 low, high;  ///< of the model in the plane
  double scale_u, scale_v;

  double u(double x) const { return margin_left + (x - low.x) * scale_u; }
  double v(double y) const { return margin_top + (high.y - y) * scale_v; }
  double width() const { return margin_left + (high.x - low.x) * scale_u + margin_right; }
  double height() const { return margin_top + (high.y - low.y) * scale_v + margin_bottom; }
  std::string point(const Vec2& p) const { return pixels(u(p.x)) + " " + pixels(v(p.y)); }
};

Frame frame_of(const Section& section, const Box3& bounds) {
  const std::size_t u = section.axis == 0 ? 1 : 0, v = section.axis == 2 ? 1 : 2;
  Frame frame{{bounds.min[u], bounds.min[v]}, {bounds.max[u], bounds.max[v]}, 1, 1};
  const double stretch = v == 2 ? vertical_exaggeration(bounds) : 1;
  const double wide = std::max(frame.high.x - frame.low.x, 1e-300),
               tall = std::max(frame.high.y - frame.low.y, 1e-300) * stretch;
  const double room = picture_width - margin_left - margin_right;
  frame.scale_u = std::min(room / wide, room / tall);
  frame.scale_v = frame.scale_u * stretch;
  return frame;
}

/// A round step that gives three to eight ticks over the range.
double tick_step(double range) {
  const double rough = range / 5, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (double factor : {1.0, 2.0, 5.0})
    if (power * factor >= rough) return power * factor;
  return power * 10;
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text) {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" + std::string(anchor) + "\">" +
         escape(text) + "</text>";
}

std::string coordinate(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string draw_axes(const Frame& frame, std::size_t axis) {
  static constexpr std::array<const char*, 3> names{"x", "y", "z"};
  std::string out = "<rect class=\"frame\" x=\"" + pixels(margin_left) + "\" y=\"" + pixels(margin_top) +
                    "\" width=\"" + pixels(frame.width() - margin_left - margin_right) + "\" height=\"" +
                    pixels(frame.height() - margin_top - margin_bottom) + "\"/>";
  const double bottom = frame.height() - margin_bottom;
  const double step_u = tick_step(frame.high.x - frame.low.x), step_v = tick_step(frame.high.y - frame.low.y);
  for (double k = std::ceil(frame.low.x / step_u); k * step_u <= frame.high.x; ++k)
    out += text_at(frame.u(k * step_u), bottom + 15, "middle", coordinate(k * step_u));
  for (double k = std::ceil(frame.low.y / step_v); k * step_v <= frame.high.y; ++k)
    out += text_at(margin_left - 5, frame.v(k * step_v) + 4, "end", coordinate(k * step_v));
  out += text_at((margin_left + frame.width() - margin_right) / 2, bottom + 32, "middle", names[axis == 0 ? 1 : 0]);
  out += text_at(12, (margin_top + bottom) / 2, "middle", names[axis == 2 ? 1 : 2]);
  return out;
}

}  // namespace

std::string escape(std::string_view text) {
  std::string out;
  for (char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string colour(std::size_t row) {
  // Steps of the golden angle on the colour wheel; lightness alternates so that a long list stays readable.
  const double hue = std::fmod(40.0 + 137.508 * static_cast<double>(row), 360.0);
  const double lightness = std::array{0.66, 0.52, 0.76}[row % 3], chroma = 0.55 * (1 - std::abs(2 * lightness - 1));
  const double x = chroma * (1 - std::abs(std::fmod(hue / 60, 2.0) - 1));
  const std::array<std::array<double, 3>, 6> sectors{
      {{chroma, x, 0}, {x, chroma, 0}, {0, chroma, x}, {0, x, chroma}, {x, 0, chroma}, {chroma, 0, x}}};
  const std::array<double, 3>& rgb = sectors[static_cast<std::size_t>(hue / 60) % 6];
  char text[16];
  const auto channel = [&](double c) { return static_cast<int>(std::lround(255 * (c + lightness - chroma / 2))); };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", channel(rgb[0]), channel(rgb[1]), channel(rgb[2]));
  return text;
}

double vertical_exaggeration(const Box3& bounds) {
  const double across = std::max(bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y),
               high = bounds.max.z - bounds.min.z;
  if (!(high > 0) || high >= 0.3 * across) return 1;
  for (double power = 1; power < 1e9; power *= 10)
    for (double factor : {2.0, 5.0, 10.0})
      if (high * power * factor >= 0.3 * across) return power * factor;
  return 1e9;
}

std::string draw_section(const Section& section, const Box3& bounds) {
  const Frame frame = frame_of(section, bounds);
  std::map<std::int32_t, std::string> fills;
  for (const Section::Cut& cut : section.cuts) {
    std::string& path = fills[cut.region];
    for (std::size_t i = 0; i < cut.polygon.size(); ++i)
      path.append(i == 0 ? "M" : "L").append(frame.point(cut.polygon[i]));
    path += "Z";
  }
  std::string traces;
  for (const Section::Trace& t : section.traces)
    traces.append("M").append(frame.point(t.a)).append("L").append(frame.point(t.b));
  static constexpr std::array<const char*, 3> names{"x", "y", "z"};
  std::string out = std::string("<svg role=\"img\" aria-label=\"Section at ") + names[section.axis] + " = " +
                    number(section.at) + "\" viewBox=\"0 0 " + pixels(frame.width()) + " " + pixels(frame.height()) +
                    "\" width=\"" + pixels(frame.width()) + "\">";
  for (const auto& [region, path] : fills)
    out += "<path class=\"unit\" fill=\"" + colour(static_cast<std::size_t>(region - 1)) + "\" d=\"" + path + "\"/>";
  out += "<path class=\"trace\" d=\"" + traces + "\"/>" + draw_axes(frame, section.axis) + "</svg>\n";
  return out;
}

std::string draw_histogram(const std::vector<std::size_t>& counts, double width, std::string_view quantity) {
  constexpr double wide = 360, tall = 180, left = 10, bottom = 40, top = 20;
  const std::size_t most =
      std::max<std::size_t>(1, counts.empty() ? 1 : *std::max_element(counts.begin(), counts.end()));
  const double bar = (wide - 2 * left) / static_cast<double>(std::max<std::size_t>(1, counts.size()));
  std::string out =
      "<svg role=\"img\" aria-label=\"Histogram: " + escape(quantity) + "\" viewBox=\"0 0 360 180\" width=\"360\">";
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const double height = (tall - bottom - top) * static_cast<double>(counts[k]) / static_cast<double>(most);
    const double from = static_cast<double>(k) * width;
    out += "<rect class=\"bar\" x=\"" + pixels(left + static_cast<double>(k) * bar) + "\" y=\"" +
           pixels(tall - bottom - height) + "\" width=\"" + pixels(bar - 1) + "\" height=\"" + pixels(height) +
           "\"><title>" + number(from) + " to " + number(from + width) + ": " + std::to_string(counts[k]) +
           "</title></rect>";
  }
  const std::size_t every = counts.size() > 10 ? 3 : 1;
  for (std::size_t k = 0; k <= counts.size(); k += every)
    out += text_at(left + static_cast<double>(k) * bar, tall - bottom + 15, "middle",
                   number(static_cast<double>(k) * width));
  out += text_at(wide / 2, tall - 6, "middle", quantity) +
         text_at(left, 12, "start", "largest bar: " + std::to_string(most)) + "</svg>\n";
  return out;
}

}  // namespace geomesh::geomodel::page
