// A page that shows a picture and the messages about it, and shows both again when they change. It needs no server: it
// reads a small script next to it again and again, which also works if the browser opened the page from a folder.
//
//   files.add(page_path("out/rust.png"), page_text("out/rust.png"));   // once
//   files.add(state_path("out/rust.png"), state_text({.version = 7, .subject = "rust.graph.json", .ok = true}));
#pragma once

#include <cstdint>
#include <string>

namespace patina::cli {

// The names of the files that belong to a picture: "out/rust.png" -> "out/rust.html", "out/rust.js".
std::string page_path(const std::string& picture);
std::string state_path(const std::string& picture);

// The page for a picture: HTML.
std::string page_text(const std::string& picture);

// What the page shows now. A later state has a greater `version`.
struct PageState {
    std::int64_t version = 0;
    std::string subject{};  // the graph or the scene in the picture
    bool ok = false;        // the picture shows the subject as it is; else as it was
    std::string text{};
};
std::string state_text(const PageState& state);

}  // namespace patina::cli
