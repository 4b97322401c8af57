// Files of the disk. The whole project reads files through these functions, and tests/layering.cmake checks that no
// other file opens one. Only regular files are read. A device, a FIFO or a folder is refused before it is opened, and
// the check is repeated when the file is open. At most as many bytes are read as the caller allows, whatever size the
// system reports. If reading is confined to a root, nothing outside of it is read, found or listed.
//
//   DiskFile file = read_disk("rust.graph.json", 1 << 20);
//   if (file.bytes) use(*file.bytes);
//   else if (file.why.empty()) ...           // there is no such file
//   else complain(path, file.why);           // "it is a FIFO", "it has more than 1048576 bytes", "Permission denied"
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "compiler/base/disk/root.h"

namespace patina {

struct DiskFile {
    std::optional<std::string> bytes{};
    std::string why{};          // why there are none; empty: there is no such file
    std::uint64_t size = 0;     // of the file, as far as it is known
    bool is_too_large = false;  // the file has more bytes than allowed; `text` is empty
};

// The limit for texts, of this project and of others.
inline constexpr std::uint64_t kMostTextBytes = std::uint64_t{64} << 20;

// In these functions, if `root` is null, the root of the process is used. This root holds all of the disk. It is only
// for files that the program itself writes or owns, and that no file from elsewhere names.
const Root* anywhere();

// The whole file.
DiskFile read_disk(const std::string& path, std::uint64_t most, const Root* root = nullptr);
// Its first bytes; fewer if it has fewer.
DiskFile read_beginning(const std::string& path, std::size_t count, const Root* root = nullptr);

// The same without reading: `bytes` is set, and empty, if the file can be opened.
DiskFile look_on_disk(const std::string& path, const Root* root = nullptr);
bool is_on_disk(const std::string& path, const Root* root = nullptr);
// False for a folder that must not be listed.
bool is_folder_on_disk(const std::string& path, const Root* root = nullptr);

// The path of an existing file with all links resolved, for messages to users who did not choose the name of a link.
// The path itself, if it is no link.
std::string without_links(const std::string& path);

// Why the path must not be read; empty: it may be. "it is outside of the root folder 'art'"
std::string why_outside(const std::string& path, const Root* root = nullptr);

// Why no file must be written there; empty: one may be. What the root does not hold by name may be written, but by no
// link of the root's. "a link leads outside of the root folder 'art'"
std::string why_unwritable(const std::string& path, const Root* root = nullptr);
// True for a path without links that lies in the root. False for each if there is no root.
bool is_in_root(const std::string& real_path, const Root* root = nullptr);

// Confines all reading of this process to a folder, and what is written into the folder, too. A program calls it once,
// before it starts threads. The library never does: a program that embeds it chooses a root for each compilation.
void confine_disk(const std::string& folder);

// Standard input, to its end. Nothing, and why: it has more bytes.
std::optional<std::string> read_standard_input(std::uint64_t most, std::string& why);

}  // namespace patina
