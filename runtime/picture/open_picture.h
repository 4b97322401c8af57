// Opens the bytes of a picture with one reader of OpenImageIO, chosen by its bytes or its name, after its header has
// been checked. OpenImageIO's own way, ImageInput::open(), tries all of its readers if that one fails, also those of
// raw photographs and films. Some of them read the file on the disk instead of the bytes.
//
//   MemoryReader memory(bytes);
//   std::string why;
//   const auto input = open_picture({.path = path, .bytes = bytes}, memory, why);
#pragma once

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>
#include <string_view>

#include "runtime/picture/openimageio.h"

namespace patina::runtime {

struct PictureBytes {
    const std::string& path;  // for its ending
    std::string_view bytes;
    // Where OpenImageIO may open the picture itself, if it cannot read it from memory (HEIF, ICO, SGI, FITS, Cineon and
    // raw pictures); empty: nowhere.
    std::string file{};
};

// Null after an error, which `why` then says. `memory` must outlive the result. Some readers throw for damaged headers.
std::unique_ptr<OIIO::ImageInput> open_picture(const PictureBytes& picture, MemoryReader& memory, std::string& why);

}  // namespace patina::runtime
