// The differences of two texts, line by line, with the lines around them. The algorithm is from Myers, "An O(ND)
// Difference Algorithm and Its Variations" (1986), and finds the fewest differences.
//
//   for (const DiffLine& line : differences(old_text, new_text)) ...
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "patina/export.h"

namespace patina {

// A line of the differences.
struct DiffLine {
    // Which text has the line: both, the old one, or the new one; or a gap, where equal lines are left out.
    enum class Kind { Same, Removed, Added, Gap } kind = Kind::Same;  // which of them it is
    int old_line = 0, new_line = 0;                                   // from 1; 0: the text does not have it
    std::string text{};                                               // without its line break; of a gap: empty
};

inline constexpr int kDiffContext = 3;  // lines before and after a difference

// Empty if the texts are equal. If the texts have very many differences, the result may have more lines than necessary.
PATINA_API std::vector<DiffLine> differences(std::string_view old_text, std::string_view new_text);
// The same with all lines, also those that are equal, and without gaps. Equal texts have lines here, too.
PATINA_API std::vector<DiffLine> all_lines(std::string_view old_text, std::string_view new_text);
// The number of lines that were added or removed.
PATINA_API std::size_t changed_lines(const std::vector<DiffLine>& diff);

}  // namespace patina
