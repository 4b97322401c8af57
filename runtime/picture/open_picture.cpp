#include "runtime/picture/open_picture.h"

#include <algorithm>
#include <filesystem>

#include "compiler/base/letters.h"
#include "runtime/picture/formats/header_fault.h"
#include "runtime/picture/formats/picture_kind.h"

namespace patina::runtime {
namespace {

// The word of OpenImageIO for the format, "openexr", by which it makes a reader without looking at any file. Empty: it
// has none.
std::string reader_of(const PictureBytes& picture) {
    static const auto kExtensions = OIIO::get_extension_map();
    const PictureKind* const kind = picture_kind(picture.bytes);
    std::string ending =
        kind ? std::string(kind->endings[0]) : std::filesystem::path(picture.path).extension().string();
    if (!ending.empty()) ending.erase(0, 1);
    ending = small_letters(ending);
    const auto found = std::ranges::find_if(kExtensions, [&](const auto& format) {
        return std::ranges::find(format.second, ending) != format.second.end();
    });
    return found == kExtensions.end() ? std::string() : found->first;
}

// Some readers take as much memory as a header says as soon as they open a file.
std::string fault_of(const PictureBytes& picture) {
    std::string fault = picture_fault(picture.path, picture.bytes);
    return fault.empty() ? header_fault(picture.bytes) : fault;
}

}  // namespace

std::unique_ptr<OIIO::ImageInput> open_picture(const PictureBytes& picture, MemoryReader& memory, std::string& why) {
    why = fault_of(picture);
    if (!why.empty()) return nullptr;
    const std::string reader = reader_of(picture);
    std::unique_ptr<OIIO::ImageInput> input = reader.empty() ? nullptr : OIIO::ImageInput::create(reader);
    if (!input) {
        why = "neither its first bytes nor its name belong to a format that can be read";
        OIIO::geterror();  // or it would be the next file's
        return nullptr;
    }
    const bool from_memory = input->supports("ioproxy");
    if (!from_memory && picture.file.empty()) {
        why = "its format cannot be read from memory: convert it to PNG, or to OpenEXR if it is HDR";
        return nullptr;
    }
    OIIO::ImageSpec wanted, found;
    wanted.attribute("oiio:UnassociatedAlpha", 1);  // a texture's alpha is data: keep the colours under it
    OIIO::Filesystem::IOProxy* proxy = &memory;
    if (from_memory) wanted.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    if (input->open(from_memory ? picture.path : picture.file, found, wanted)) return input;
    why = reason(input->geterror());
    OIIO::geterror();
    return nullptr;
}

}  // namespace patina::runtime
