// What the header of a picture says that its decoder must not be given. Some libraries that decode pictures allocate
// memory for all pixels, or for tables of offsets, while they open a file. So the sizes are read first.
//
//   header_fault(bytes);                // "it is 16384 x 16384 pixels, and the limit is ...: --max-pixels allows ..."
#pragma once

#include <string>
#include <string_view>

namespace patina::runtime {

// Of OpenEXR, WebP, JPEG, JPEG 2000, TIFF, GIF, Photoshop and DDS; nothing for other kinds, whose decoders take memory
// late. If a header cannot be read, the decoder reports that. If it claims more than the file can hold, it is reported
// here.
std::string header_fault(std::string_view bytes);

}  // namespace patina::runtime
