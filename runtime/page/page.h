// The room `page` makes pages of HTML that need no other file, and drawings of graphs. It renders nothing.
//
// A page: page.html is its frame, with the style and the scripts of all pages. Its content is passed as HTML, and its
// pictures are inside of it.
//
//   std::string cards = "<section class=\"card\"><h2>" + escaped(name) + "</h2>" + picture_tag(png, name) +
//   "</section>"; write_file("index.html", make_page({.title = "Graphs of art", .tools = {}, .content = cards}));
#pragma once

#include <string>
#include <string_view>

namespace patina::runtime {

struct Page {
    std::string title{};    // text
    std::string tools{};    // HTML, next to the title
    std::string content{};  // HTML
};
std::string make_page(const Page& page);

// A folder's own name for a title: "." and "art/" have one, too.
std::string folder_name(const std::string& folder);

// RFC 4648.
std::string base64(std::string_view bytes);

// An image whose bytes are in the page. `what` is read where it cannot be seen; `css` are classes.
std::string picture_tag(std::string_view png, std::string_view what, std::string_view css = {});

// A button that shows one kind of the elements with the attribute data-case: "3 failed", "2 scenes" with the ending
// "s".
std::string kind_button(std::string_view kind, std::size_t count, std::string_view ending = {});

}  // namespace patina::runtime
