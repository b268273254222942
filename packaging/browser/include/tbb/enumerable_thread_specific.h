// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

namespace tbb {

/// The object of the one thread, made where it is asked for first.
template <class T>
class enumerable_thread_specific {
 public:
  enumerable_thread_specific() : make_([] { return T(); }) {}
  /// From a function that makes the object, or from an object that is copied.
  template <class Source>
  enumerable_thread_specific(Source source) {
    if constexpr (std::is_invocable_v<Source>)
      make_ = std::move(source);
    else
      make_ = [source] { return T(source); };
  }
  T& local() {
    if (!object_) object_.emplace(make_());
    return *object_;
  }
  T* begin() { return object_ ? &*object_ : nullptr; }
  T* end() { return object_ ? &*object_ + 1 : nullptr; }

 private:
  std::function<T()> make_;
  std::optional<T> object_;
};

}  // namespace tbb
