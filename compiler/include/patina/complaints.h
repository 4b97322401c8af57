// Makes the diagnostics of programs around the compiler: the command, the importers, the runtime. The table is
// complaints.def; no code is written as a word where it is used.
//
//   Diagnostic wrong = complaint(Complaint::CannotRead, {"rust.png", "no such file"});
//   std::puts(to_text(wrong).c_str());   // error: cannot read 'rust.png': no such file [cannot-read]
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "patina/patina.h"

namespace patina {

// What is wrong: the name of a row of complaints.def.
enum class Complaint {
#define COMPLAINT(name, code, message) name,
#include "patina/complaints.def"
#undef COMPLAINT
};

// The code of a diagnostic: "cannot-read".
PATINA_API std::string_view code_of(Complaint what);
// An error without a place. `words` fill the {} of the message in order, or {0}, {1} by number.
PATINA_API Diagnostic complaint(Complaint what, std::initializer_list<std::string_view> words);
// Every code of the table once, in its order.
PATINA_API std::vector<std::string_view> complaint_codes();

}  // namespace patina
