// Pictures of one size in a grid, with labels: a row, a table, or a contact sheet.
//
//   SheetLayout layout{.columns = 3, .column_labels = {"0", "0.5", "1"}};
//   Outcome<Image> sheet = contact_sheet(layout, cells);
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "runtime/outcome.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

// Labels may be missing.
struct SheetLayout {
    int columns = 1;
    std::vector<std::string> column_labels{};  // above the first row
    std::vector<std::string> row_labels{};     // to the left of each row
    std::vector<std::string> cell_labels{};    // above each picture
};

// Pixels of the sheet, width and height, for cells of this size.
Outcome<std::array<int, 2>> sheet_size(const SheetLayout& layout, std::size_t cells, int width, int height);

// The cells are linear, row by row. A last row may have fewer of them.
Outcome<Image> contact_sheet(const SheetLayout& layout, std::span<const Image> cells);

}  // namespace patina::runtime
