// How many cells of a terminal a character takes. By the Unicode Character Database 14.0: UnicodeData.txt (general
// categories) and EastAsianWidth.txt (UAX #11). What a font does with a sequence of characters, such as a flag, is not
// known here: each character counts alone.
//
//   cells_of(U'漢')   // 2; a combining accent takes 0, and a letter 1
#pragma once

#include <cstddef>

namespace patina {

// 0, 1 or 2. Control characters do not matter here: callers that show a line replace them.
std::size_t cells_of(char32_t character);

}  // namespace patina
