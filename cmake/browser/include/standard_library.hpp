// SPDX-License-Identifier: MIT
/// @file
/// Parts of the C++20 standard library that the libc++ of emscripten 3.1.6 (libc++ 13) lacks, in the forms that this
/// tree uses. The build for browsers includes this header before every source. A program in a browser has one thread,
/// so std::atomic_ref needs no atomic instructions. Each part can be removed once emscripten's library has it.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <compare>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace std {

template <class T>
class atomic_ref {
 public:
  explicit atomic_ref(T& value) : value_(&value) {}
  T load(memory_order = memory_order_seq_cst) const { return *value_; }
  void store(T value, memory_order = memory_order_seq_cst) const { *value_ = value; }
  T fetch_add(T value, memory_order = memory_order_seq_cst) const { return std::exchange(*value_, *value_ + value); }
  bool compare_exchange_weak(T& expected, T desired, memory_order = memory_order_seq_cst) const {
    if (*value_ == expected) {
      *value_ = desired;
      return true;
    }
    expected = *value_;
    return false;
  }

 private:
  T* value_;
};

#ifndef __cpp_lib_bit_cast
template <class To, class From>
To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}
#endif

// Three-way comparison of containers, which defaulted comparisons of their owners call.
template <class T>
constexpr auto three_way(const T& a, const T& b) {
  if constexpr (requires { a <=> b; }) {
    return a <=> b;
  } else {
    return a < b ? weak_ordering::less : b < a ? weak_ordering::greater : weak_ordering::equivalent;
  }
}
template <class T, size_t N>
constexpr auto operator<=>(const array<T, N>& a, const array<T, N>& b) -> decltype(three_way(a[0], b[0])) {
  for (size_t i = 0; i < N; ++i)
    if (const auto order = three_way(a[i], b[i]); order != 0) return order;
  return decltype(three_way(a[0], b[0]))::equivalent;
}
template <class T>
constexpr auto operator<=>(const vector<T>& a, const vector<T>& b) -> decltype(three_way(a[0], b[0])) {
  for (size_t i = 0; i < a.size() && i < b.size(); ++i)
    if (const auto order = three_way(a[i], b[i]); order != 0) return order;
  return a.size() <=> b.size();
}
template <class A, class B>
constexpr auto operator<=>(const pair<A, B>& a, const pair<A, B>& b)
    -> common_comparison_category_t<decltype(three_way(a.first, b.first)), decltype(three_way(a.second, b.second))> {
  if (const auto order = three_way(a.first, b.first); order != 0) return order;
  return three_way(a.second, b.second);
}
inline strong_ordering operator<=>(const string& a, const string& b) { return a.compare(b) <=> 0; }

namespace ranges {

template <class R, class F, class P = identity>
bool all_of(R&& range, F is, P value = {}) {
  return std::all_of(begin(range), end(range), [&](auto&& x) { return std::invoke(is, std::invoke(value, x)); });
}
template <class R, class F, class P = identity>
bool any_of(R&& range, F is, P value = {}) {
  return std::any_of(begin(range), end(range), [&](auto&& x) { return std::invoke(is, std::invoke(value, x)); });
}
template <class R, class F, class P = identity>
bool none_of(R&& range, F is, P value = {}) {
  return !ranges::any_of(range, is, value);
}
template <class R, class F>
auto count_if(R&& range, F is) {
  return std::count_if(begin(range), end(range), [&](auto&& x) { return std::invoke(is, x); });
}
template <class R, class T>
auto count(R&& range, const T& value) {
  return std::count(begin(range), end(range), value);
}
template <class R, class T>
auto find(R&& range, const T& value) {
  return std::find(begin(range), end(range), value);
}
template <class R, class T>
void fill(R&& range, const T& value) {
  std::fill(begin(range), end(range), value);
}
template <class C, class P>
auto by(C& is_less, P& value) {
  return [&](auto&& a, auto&& b) { return std::invoke(is_less, std::invoke(value, a), std::invoke(value, b)); };
}
template <class R, class C = std::less<>, class P = identity>
void sort(R&& range, C is_less = {}, P value = {}) {
  std::sort(begin(range), end(range), by(is_less, value));
}
template <class R, class C = std::less<>, class P = identity>
void stable_sort(R&& range, C is_less = {}, P value = {}) {
  std::stable_sort(begin(range), end(range), by(is_less, value));
}
template <class R, class C = std::less<>, class P = identity>
auto min(R&& range, C is_less = {}, P value = {}) {
  return *std::min_element(begin(range), end(range), by(is_less, value));
}
template <class R, class T, class C = std::less<>, class P = identity>
auto lower_bound(R&& range, const T& at, C is_less = {}, P value = {}) {
  return std::lower_bound(begin(range), end(range), at,
                          [&](auto&& x, auto&& y) { return std::invoke(is_less, std::invoke(value, x), y); });
}
template <class R, class T, class C = std::less<>, class P = identity>
auto equal_range(R&& range, const T& at, C is_less = {}, P value = {}) {
  const auto first = ranges::lower_bound(range, at, is_less, value);
  return std::pair(first, std::upper_bound(first, end(range), at, [&](auto&& x, auto&& y) {
                     return std::invoke(is_less, x, std::invoke(value, y));
                   }));
}
template <class A, class B, class Out>
Out set_symmetric_difference(const A& a, const B& b, Out out) {
  return std::set_symmetric_difference(begin(a), end(a), begin(b), end(b), out);
}

}  // namespace ranges

// Numbers as text. The C library of emscripten (musl) rounds correctly both ways, so the digits are those of every
// other library, whatever the number.

template <class Real>
requires is_floating_point_v<Real> from_chars_result from_chars(const char* first, const char* last, Real& value,
                                                                chars_format = chars_format::general) {
  const auto is_digit = [&](const char* at) { return at < last && *at >= '0' && *at <= '9'; };
  const auto skip_digits = [&](const char* at) {
    while (is_digit(at)) ++at;
    return at;
  };
  const char *const start = first < last && *first == '-' ? first + 1 : first, *end = skip_digits(start);
  ptrdiff_t n_digits = end - start;
  if (end < last && *end == '.') {
    const char* const after = skip_digits(end + 1);
    n_digits += after - end - 1;
    if (n_digits > 0) end = after;
  }
  if (n_digits == 0) {
    for (const char* const word : {"infinity", "inf", "nan"}) {
      const auto length = static_cast<ptrdiff_t>(strlen(word));
      if (last - start < length ||
          !std::equal(word, word + length, start, [](char a, char b) { return a == (b | 32); }))
        continue;
      value = (start == first ? Real(1) : Real(-1)) *
              (*word == 'n' ? numeric_limits<Real>::quiet_NaN() : numeric_limits<Real>::infinity());
      return {start + length, errc()};
    }
    return {first, errc::invalid_argument};
  }
  if (end < last && (*end | 32) == 'e') {
    const char* const sign = end + 1;
    const char* const power = sign < last && (*sign == '-' || *sign == '+') ? sign + 1 : sign;
    if (is_digit(power)) end = skip_digits(power);
  }
  const string text(first, end);
  const Real read = is_same_v<Real, float> ? static_cast<Real>(strtof(text.c_str(), nullptr))
                                           : static_cast<Real>(strtod(text.c_str(), nullptr));
  const bool is_zero = text.find_first_of("123456789") >= min(text.find_first_of("eE"), text.size());
  if (std::isinf(read) || (read == 0 && !is_zero)) return {end, errc::result_out_of_range};
  value = read;
  return {end, errc()};
}

inline to_chars_result put_chars(char* first, char* last, const char* text, int length) {
  if (length > last - first) return {last, errc::value_too_large};
  return {std::copy(text, text + length, first), errc()};
}

/// With a precision, as printf.
template <class Real>
requires is_floating_point_v<Real> to_chars_result to_chars(char* first, char* last, Real value, chars_format format,
                                                            int precision) {
  char text[512];
  const char* const pattern = format == chars_format::fixed        ? "%.*f"
                              : format == chars_format::scientific ? "%.*e"
                                                                   : "%.*g";
  return put_chars(first, last, text, snprintf(text, sizeof text, pattern, precision, static_cast<double>(value)));
}

/// The shortest text that reads back as the value; without exponent where that is no longer.
template <class Real>
requires is_floating_point_v<Real> to_chars_result to_chars(char* first, char* last, Real value) {
  char text[512], plain[512];
  if (!std::isfinite(value))
    return put_chars(
        first, last, text,
        snprintf(text, sizeof text, "%s%s", std::signbit(value) ? "-" : "", std::isnan(value) ? "nan" : "inf"));
  int digits = 0, length = 0;
  for (;; ++digits) {
    length = snprintf(text, sizeof text, "%.*e", digits, static_cast<double>(value));
    if ((is_same_v<Real, float> ? static_cast<Real>(strtof(text, nullptr))
                                : static_cast<Real>(strtod(text, nullptr))) == value)
      break;
  }
  const int power = atoi(strchr(text, 'e') + 1);
  const int plain_length = snprintf(plain, sizeof plain, "%.*f", max(digits - power, 0), static_cast<double>(value));
  return plain_length <= length ? put_chars(first, last, plain, plain_length) : put_chars(first, last, text, length);
}

}  // namespace std
