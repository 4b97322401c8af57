// file_hash(): FNV-1a (Fowler, Noll and Vo, "The FNV Non-Cryptographic Hash Algorithm"), which is three lines in any
// language, so that every reader can have it.
#include <fmt/format.h>

#include <cstdint>

#include "patina/reflection.h"

namespace patina {

std::string file_hash(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    return fmt::format("{:016x}", hash);
}

}  // namespace patina
