// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Composes the text of solver files: numbers do not depend on the locale, and a double is written as the shortest text
/// that reads back to the same double.
#pragma once

#include <charconv>
#include <concepts>
#include <filesystem>
#include <string>
#include <string_view>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

class TextBuffer {
 public:
  TextBuffer& operator<<(std::string_view text) {
    text_.append(text);
    return *this;
  }
  template <std::integral T>
  TextBuffer& operator<<(T value) {
    return number(value);
  }
  TextBuffer& operator<<(double value) { return number(value); }
  TextBuffer& operator<<(const Vec3& p) { return *this << p.x << " " << p.y << " " << p.z; }
  const std::string& text() const { return text_; }

 private:
  template <class T>
  TextBuffer& number(T value) {
    char buffer[32];
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
    return *this;
  }
  std::string text_;
};

}  // namespace geomesh::geomodel
