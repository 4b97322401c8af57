// A value, or one sentence that explains the failure. It is used if a user reads failures as text (files, devices).
// Problems in a graph are patina::Diagnostics instead, because they have a location.
//
//   Outcome<Image> image = load_image("rust.png");
//   if (!image) return Failure{image.error};
//   use(image.value);
#pragma once

#include <string>
#include <utility>

namespace patina::runtime {

struct Failure {
    std::string error;  // lower case, no full stop; never empty
};

template <class T>
struct Outcome {
    T value{};
    std::string error;  // empty: `value` is good

    Outcome(T good) : value(std::move(good)) {}
    Outcome(Failure failure) : error(std::move(failure.error)) {}
    explicit operator bool() const { return error.empty(); }
};

}  // namespace patina::runtime
