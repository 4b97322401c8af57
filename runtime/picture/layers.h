// One EXR file with several pictures: the channels R, G, B and A are the picture, and each layer has channels of its
// own
// ("normalWS.R"), as compositing programs and OpenImageIO name them.
//
//   Outcome<std::string> bytes = encode_layers(picture, layers);   // layers: {{"normalWS", image}}
#pragma once

#include <span>
#include <string>

#include "runtime/outcome.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

struct Layer {
    std::string name{};
    Image image{};  // as large as the picture
};

// 32-bit floats, the numbers as they are. Equal pictures have equal bytes. (write_image.cpp)
Outcome<std::string> encode_layers(const Image& picture, std::span<const Layer> layers);

}  // namespace patina::runtime
