// The diagnostics of the command, the importers and the runtime, and hints for names of other programs. The table is
// complaints.def. Code names its rows and never writes a diagnostic's code as text.
//
//   Diagnostic wrong = complaint(Complaint::CannotRead, {"rust.png", "no such file"});
//   std::puts(to_text(wrong).c_str());   // error: cannot read 'rust.png': no such file [cannot-read]
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "patina/patina.h"

namespace patina {

// What is wrong: the name of a row of complaints.def.
enum class Complaint {
#define COMPLAINT(name, code, message) name,
#define CHECK_COMPLAINT COMPLAINT
#include "patina/complaints.def"
#undef CHECK_COMPLAINT
#undef COMPLAINT
};

// A row of complaints.def.
struct ComplaintInfo {
    std::string_view code;     // "cannot-read"
    std::string_view message;  // with a {} for each word
    bool only_checked;         // only `patina check` searches for it: `patina compile` writes the graph's files
};

// The code of a diagnostic: "cannot-read".
PATINA_API std::string_view code_of(Complaint what);
// An error without a location. `words` fill the {} of the message in order, or {0}, {1} by number.
PATINA_API Diagnostic complaint(Complaint what, std::initializer_list<std::string_view> words);
// Every row of the table, in its order. Several rows may have the same code.
PATINA_API std::span<const ComplaintInfo> all_complaints();

// A name of another program that is no node here, and what to write for it.
struct Hint {
    std::string_view name;  // "MatrixTranspose"
    std::string text;       // "written 'transpose(m)'"
};
// All hints. NodeInfo has the names that other programs give to nodes.
PATINA_API std::vector<Hint> hints();

}  // namespace patina
