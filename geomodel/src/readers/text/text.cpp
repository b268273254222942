// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/text/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace geomesh::geomodel {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Converts numbers in rare spellings: with Fortran exponents, or too large or too small for a double.
std::optional<double> to_double_slowly(std::string_view token) {
  std::string copy(token);
  for (char& c : copy)
    if (c == 'd' || c == 'D') c = 'e';
  double value = 0;
  const auto [end, ec] = std::from_chars(copy.data(), copy.data() + copy.size(), value);
  if (end != copy.data() + copy.size() || ec == std::errc::invalid_argument) return std::nullopt;
  if (ec == std::errc::result_out_of_range) {  // a number too small for a double becomes zero, one too large infinity
    const std::size_t e = copy.find_first_of("eE");
    const bool tiny = e != std::string::npos && e + 1 < copy.size() && copy[e + 1] == '-';
    return tiny ? 0.0 : HUGE_VAL;
  }
  return value;
}

}  // namespace

LineReader::LineReader(const InputFile& file)
    : file_(&file), line_end_(file.text().find('\n') == std::string_view::npos ? '\r' : '\n') {}

bool LineReader::next() {
  const std::string_view text = file_->text();
  if (next_ >= text.size()) return false;
  start_ = next_;
  const std::size_t end = std::min(text.find(line_end_, start_), text.size());
  line_ = text.substr(start_, end - start_);
  if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
  next_ = end + 1;
  ++number_;
  return true;
}

void LineReader::step_back() {
  next_ = start_;
  --number_;
}

std::string_view Tokens::next() {
  std::size_t begin = 0;
  while (begin < rest_.size() && is_blank(rest_[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest_.size() && !is_blank(rest_[end])) ++end;
  const std::string_view token = rest_.substr(begin, end - begin);
  rest_.remove_prefix(end);
  return token;
}

std::string_view Tokens::next_quoted() {
  rest_ = rest();
  if (rest_.empty() || rest_.front() != '"') return next();
  const std::size_t close = rest_.find('"', 1);
  const std::string_view inside = rest_.substr(1, close == std::string_view::npos ? close : close - 1);
  rest_.remove_prefix(close == std::string_view::npos ? rest_.size() : close + 1);
  return trim(inside);
}

std::string_view Tokens::rest() const { return trim(rest_); }

std::string_view TokenStream::next() {
  const std::string_view text = file_->text();
  for (; at_ < text.size(); ++at_) {
    const char c = text[at_];
    if (c == '\n') {
      ++line_;
    } else if (comment_ && c == comment_) {
      while (at_ + 1 < text.size() && text[at_ + 1] != '\n') ++at_;
    } else if (!is_blank(c)) {
      break;
    }
  }
  const std::size_t begin = at_;
  while (at_ < text.size() && text[at_] != '\n' && !is_blank(text[at_]) && !(comment_ && text[at_] == comment_)) ++at_;
  return text.substr(begin, at_ - begin);
}

double TokenStream::number(const char* what) {
  const std::string_view token = next();
  if (token.empty()) fail(std::string("the file ends where ") + what + " was expected (truncated?)");
  const auto value = to_double(token);
  if (!value) fail(std::string("expected ") + what + ", found " + in_quotes(token));
  if (!std::isfinite(*value)) fail(std::string(what) + " is not finite: " + in_quotes(token));
  return *value;
}

std::int64_t TokenStream::integer(const char* what) {
  const std::string_view token = next();
  if (token.empty()) fail(std::string("the file ends where ") + what + " was expected (truncated?)");
  const auto value = to_integer(token);
  if (!value) fail(std::string("expected ") + what + ", found " + in_quotes(token));
  return *value;
}

std::size_t TokenStream::count(const char* what, std::size_t least_bytes) {
  const std::int64_t n = integer(what);
  if (n < 0) fail(std::string(what) + " is negative: " + std::to_string(n));
  if (static_cast<std::uint64_t>(n) > bytes_left() / least_bytes + 1) {
    fail(std::string(what) + " is given as " + std::to_string(n) + ", but only " + std::to_string(bytes_left()) +
         " bytes follow (truncated, or a wrong count)");
  }
  return static_cast<std::size_t>(n);
}

std::string_view trim(std::string_view s) {
  while (!s.empty() && (is_blank(s.front()) || s.front() == '\n')) s.remove_prefix(1);
  while (!s.empty() && (is_blank(s.back()) || s.back() == '\n')) s.remove_suffix(1);
  return s;
}

std::string to_lower(std::string_view s) {
  std::string out(s);
  for (char& c : out) c = lower(c);
  return out;
}

std::string_view digits_at_end(std::string_view name) { return name.substr(name.find_last_not_of("0123456789") + 1); }

bool equals_ignoring_case(std::string_view a, std::string_view b) {
  return a.size() == b.size() && starts_with_ignoring_case(a, b);
}

bool starts_with_ignoring_case(std::string_view s, std::string_view prefix) {
  if (s.size() < prefix.size()) return false;
  for (std::size_t i = 0; i < prefix.size(); ++i)
    if (lower(s[i]) != lower(prefix[i])) return false;
  return true;
}

std::optional<double> to_double(std::string_view token) {
  if (!token.empty() && token.front() == '+') token.remove_prefix(1);
  if (token.empty() || token.front() == '+') return std::nullopt;
  double value = 0;
  const auto [end, ec] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (ec == std::errc() && end == token.data() + token.size()) return value;
  if (ec == std::errc::invalid_argument) return std::nullopt;
  return to_double_slowly(token);
}

std::optional<std::int64_t> to_integer(std::string_view token) {
  if (!token.empty() && token.front() == '+') token.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, ec] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (ec != std::errc() || end != token.data() + token.size() || token.empty()) return std::nullopt;
  return value;
}

double finite_number(const LineReader& at, std::string_view token, const char* what) {
  if (token.empty()) at.fail(std::string("the line ends where ") + what + " was expected");
  const auto value = to_double(token);
  if (!value) at.fail(std::string("expected ") + what + ", found " + in_quotes(token));
  if (!std::isfinite(*value)) at.fail(std::string(what) + " is not finite: " + in_quotes(token));
  return *value;
}

Vec3 read_point(const LineReader& at, Tokens& tokens, std::string_view id) {
  Vec3 p;
  static constexpr const char* axis[3] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view token = tokens.next();
    const auto value = to_double(token);
    if (value && std::isfinite(*value)) {
      p[i] = *value;
      continue;
    }
    const std::string what = std::string("coordinate ") + axis[i] + " of point " + std::string(id);
    (void)finite_number(at, token, what.c_str());
  }
  return p;
}

}  // namespace geomesh::geomodel
