// SPDX-License-Identifier: GPL-3.0-or-later
// Reads fault sticks in the format of Charisma, which Petrel and OpendTect export, one point per line:
//   INLINE-  <inline>  <crossline>  <x>  <y>  <z>  <name of the fault>  <number of the stick>
#include <map>

#include "readers/formats.hpp"
#include "readers/tables/first_lines.hpp"
#include "readers/text/frame.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the text behind the line type (such as "INLINE-") with which a line of a Charisma file begins; empty if the
/// line does not begin with a line type.
std::string_view behind_line_type(std::string_view line) {
  line = trim(line);
  for (const std::string_view type : {"INLINE-", "CROSSLINE-", "XLINE-", "CRSLINE-", "TRACE-", "RANDOM-"})
    if (starts_with_ignoring_case(line, type)) return line.substr(type.size());
  return {};
}

struct StickPoint {
  Vec3 point;
  std::string fault, stick;
};

StickPoint read_point(const LineReader& lines, std::string_view rest) {
  Tokens tokens(rest);
  double numbers[5] = {};
  for (double& number : numbers) {
    const std::string_view token = tokens.next();
    const auto value = to_double(token);
    if (!value) lines.fail("inline, crossline, x, y and z of a fault stick were expected, found " + in_quotes(token));
    number = *value;
  }
  StickPoint p{{numbers[2], numbers[3], numbers[4]}, "", ""};
  for (std::string_view token = tokens.next(); !token.empty(); token = tokens.next()) {
    if (!p.stick.empty()) p.fault += (p.fault.empty() ? "" : " ") + p.stick;
    p.stick = token;
  }
  return p;
}

}  // namespace

bool is_charisma(const InputFile& file) {
  if (looks_binary(file)) return false;
  LineReader lines(file);
  return count_numbers(behind_line_type(first_lines(lines).first)) >= 5;
}

FileContents read_charisma(const InputFile& file) {
  FileContents contents;
  contents.format = "Charisma fault sticks";
  // Row of each fault stick among the polylines, by the name of the fault and the number of the stick.
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::map<std::string, std::size_t> n_sticks;
  LineReader lines(file);
  while (lines.next()) {
    const std::string_view line = trim(lines.line());
    if (line.empty() || line.front() == '#' || line.front() == '!') continue;
    const std::string_view rest = behind_line_type(line);
    if (rest.empty()) lines.fail("INLINE- or CROSSLINE- was expected at the beginning of the line");
    StickPoint p = read_point(lines, rest);
    if (p.fault.empty()) p.fault = file.path.stem().string();
    const auto [stick, is_new] = known.try_emplace({p.fault, p.stick}, contents.polylines.size());
    if (is_new) contents.polylines.push_back({p.fault + "__" + std::to_string(++n_sticks[p.fault]), file.shown(), {}});
    contents.polylines[stick->second].points.push_back(p.point);
  }
  convert_by_frame(file, contents);
  return contents;
}

}  // namespace geomesh::geomodel
