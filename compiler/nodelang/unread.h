// Declarations of the library that are parsed when somebody first asks for them, by any thread. Of hundreds, a
// compilation needs a few. The lines alone show where each begins and ends. A declaration begins at the left margin,
// after its comments and attributes, and ends with a '}' there, or at the end of its only line.
//
//   std::deque<Unread> unread;
//   if (!split({.text = text, .base = base}, unread)) parse_file(...);   // not written so: read it at once
#pragma once

#include <deque>

#include "compiler/base/made_once.h"
#include "compiler/nodelang/parse.h"

namespace patina::nodelang {

class Unread {
public:
    // `text`: the declaration's, with its comments.
    Unread(std::string_view name, Text text) : name_(name), text_(text) {}

    std::string_view name() const { return name_; }
    // What it declares; nothing if it has an error.
    const Ast& ast() const;

private:
    std::string_view name_;
    Text text_;
    MadeOnce<Ast> ast_;  // most are never asked for
};

// Adds the declarations of a file. False, and nothing is added, if the file is not written as above, or has more than
// nodes and helpers. A request for passes, slots or semantics needs all declarations of a file.
bool split(Text file, std::deque<Unread>& into);

}  // namespace patina::nodelang
