// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace geomesh::geomodel::page {

namespace {

constexpr double picture_width = 760, margin_left = 70, margin_bottom = 40, margin_top = 12, margin_right = 30;

/// Transformation from the two coordinates in a plane section of the mesh to those of a picture, with y downwards.
struct Frame {
  Vec2 low, high;  ///< bounds of the model in the plane of the section
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

/// Returns a round step between ticks, so that an axis over the range has three to eight ticks.
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

std::string draw_axes(const Frame& frame, std::size_t axis) {
  static constexpr std::array<const char*, 3> names{"x", "y", "z"};
  std::string out = "<rect class=\"frame\" x=\"" + pixels(margin_left) + "\" y=\"" + pixels(margin_top) +
                    "\" width=\"" + pixels(frame.width() - margin_left - margin_right) + "\" height=\"" +
                    pixels(frame.height() - margin_top - margin_bottom) + "\"/>";
  const double bottom = frame.height() - margin_bottom;
  const double step_u = tick_step(frame.high.x - frame.low.x), step_v = tick_step(frame.high.y - frame.low.y);
  for (double k = std::ceil(frame.low.x / step_u); k * step_u <= frame.high.x; ++k)
    out += text_at(frame.u(k * step_u), bottom + 15, "middle", coordinate(k * step_u, frame.high.x - frame.low.x));
  for (double k = std::ceil(frame.low.y / step_v); k * step_v <= frame.high.y; ++k)
    out += text_at(margin_left - 5, frame.v(k * step_v) + 4, "end", coordinate(k * step_v, frame.high.y - frame.low.y));
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

std::string pixels(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string number(double value) {
  constexpr double shortest = 1e-4, longest = 1e15;
  char text[64];
  const double size = std::abs(value);
  if (!(size >= shortest && size < longest)) {
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
  }
  std::snprintf(text, sizeof text, "%.3e", value);  // text of the size, rounded to four digits
  const double rounded = std::strtod(text, nullptr);
  const int power = static_cast<int>(std::floor(std::log10(std::abs(rounded))));
  std::snprintf(text, sizeof text, "%.*f", std::max(0, 3 - power), rounded);
  std::string plain = text;
  const std::size_t dot = plain.find('.');
  if (dot != std::string::npos) {
    plain.erase(plain.find_last_not_of('0') + 1);
    if (plain.back() == '.') plain.pop_back();
  }
  const std::size_t first = plain.front() == '-' ? 1 : 0;
  for (std::size_t at = std::min(dot, plain.size()); at > first + 3; at -= 3) plain.insert(at - 3, ",");
  return plain;
}

std::string coordinate(double value, double range) {
  const int digits = range > 0 ? static_cast<int>(std::ceil(-std::log10(range * 1e-6))) : 0;
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(digits, 0, 15), value);
  std::string plain = text;
  if (plain.find('.') != std::string::npos) {
    plain.erase(plain.find_last_not_of('0') + 1);
    if (plain.back() == '.') plain.pop_back();
  }
  return plain == "-0" ? "0" : plain;
}

std::string draw_section(const Section& section, const Box3& bounds, const std::vector<Colour>& colours) {
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
                    coordinate(section.at, bounds.max[section.axis] - bounds.min[section.axis]) + "\" viewBox=\"0 0 " +
                    pixels(frame.width()) + " " + pixels(frame.height()) + "\" width=\"" + pixels(frame.width()) +
                    "\">";
  for (const auto& [region, path] : fills)
    out += "<path class=\"unit\" fill=\"" + to_hex(colours[static_cast<std::size_t>(region - 1)]) + "\" d=\"" + path +
           "\"/>";
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
