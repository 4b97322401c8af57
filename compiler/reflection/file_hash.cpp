// file_hash(): FNV-1a (Fowler, Noll and Vo, "The FNV Non-Cryptographic Hash Algorithm"), which needs three lines in any
// language, so that every reader can have it.
#include <fmt/format.h>

#include <cstdint>

#include "patina/reflection.h"

namespace patina {

std::string file_hash(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](char byte) { hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u; };
    // All text that a compilation writes goes through here: a loop around each byte would cost as much as the hash.
    for (; bytes.size() >= 8; bytes.remove_prefix(8)) {
        add(bytes[0]), add(bytes[1]), add(bytes[2]), add(bytes[3]);
        add(bytes[4]), add(bytes[5]), add(bytes[6]), add(bytes[7]);
    }
    for (const char byte : bytes) add(byte);
    return fmt::format("{:016x}", hash);
}

}  // namespace patina
