// A folder that reading is confined to: what a path means inside of it, through all symbolic links and "..". Nothing
// outside of the folder is looked at, so an answer does not even tell what is there. Writing is not confined to the
// folder. But a link in the folder, which may be untrusted, cannot choose a file outside to be written.
//
//   const Root root("art");
//   root.find("art/rust.png");               // "/home/me/art/textures/rust.png", if it is a link to that
//   root.find("art/../../etc/passwd");       // nothing, and so for a link that leads there
//   root.lets_write("out/rust.png");         // true: it is not a name in the folder
//   root.lets_write("art/rust.png");         // false if it is a link to "../../out/rust.png"
#pragma once

#include <optional>
#include <string>

namespace patina {

class Root {
public:
    // A folder that is not there holds nothing.
    explicit Root(const std::string& folder);

    // The path without links. It begins with the folder, as that was given or as it is without links. What does not
    // exist has a path, too. Nothing: the path, or a link on the way, leads outside.
    std::optional<std::string> find(const std::string& path) const;
    // True for a path without links, such as the system gives of an open file.
    bool holds(const std::string& real_path) const;
    // False: the path lies in the folder by its name, or passes through a link in the folder, and leads outside.
    bool lets_write(const std::string& path) const;
    // As it was given, for messages.
    const std::string& name() const { return name_; }

private:
    bool has_name(const std::string& path) const;

    std::string name_;
    std::string given_{}, real_{};  // absolute, without and with its links followed; empty: it is not there
};

}  // namespace patina
