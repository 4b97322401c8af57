#include "runtime/picture/contact_sheet.h"

#include <algorithm>

#include "runtime/picture/lettering.h"

namespace patina::runtime {
namespace {

constexpr int kGap = 4;                               // pixels between cells, and around all
constexpr std::array kPaper = {0.03f, 0.03f, 0.03f};  // linear
constexpr std::array kInk = {0.75f, 0.75f, 0.75f};

// Where everything is, in pixels.
struct Grid {
    int text = 0;  // size of the labels
    int line = 0;  // height of a line of labels
    int left = 0;  // width of the row labels
    int top = 0;   // height of the column labels
    int step_x = 0, step_y = 0;
    int width = 0, height = 0;
};

Outcome<Grid> grid_of(const SheetLayout& layout, std::size_t cells, int width, int height) {
    Grid grid{.text = std::clamp(width / 14, 10, 22)};
    grid.line = grid.text * 3 / 2;
    for (const std::string& label : layout.row_labels) {
        const Outcome<Lettering> text = lettering_within(label, grid.text, std::max(width, 60));
        if (!text) return Failure{text.error};
        grid.left = std::max(grid.left, text.value.width + 2 * kGap);
    }
    if (!layout.column_labels.empty()) grid.top = grid.line;
    grid.step_x = width + kGap;
    grid.step_y = height + kGap + (layout.cell_labels.empty() ? 0 : grid.line);
    const std::size_t columns = std::size_t(std::max(layout.columns, 1));
    const double rows = double((cells + columns - 1) / columns);
    const double all_width = grid.left + kGap + double(columns) * grid.step_x;
    const double all_height = grid.top + kGap + rows * grid.step_y;
    if (all_width > kLargestImage || all_height > kLargestImage)
        return Failure{"the sheet of " + std::to_string(cells) + " pictures would have " +
                       std::to_string((long long)all_width) + " x " + std::to_string((long long)all_height) +
                       " pixels, more than " + std::to_string(kLargestImage) +
                       " on a side: make the pictures smaller, or have fewer of them"};
    grid.width = int(all_width);
    grid.height = int(all_height);
    return grid;
}

void copy(const Image& cell, Image& sheet, int x, int y) {
    for (int row = 0; row < cell.height; ++row) {
        const std::span<const float> from = cell.at(0, row);
        std::copy_n(from.data(), std::size_t(4) * std::size_t(cell.width), sheet.at(x, y + row).data());
    }
}

}  // namespace

Outcome<std::array<int, 2>> sheet_size(const SheetLayout& layout, std::size_t cells, int width, int height) {
    const Outcome<Grid> grid = grid_of(layout, cells, width, height);
    if (!grid) return Failure{grid.error};
    return std::array{grid.value.width, grid.value.height};
}

Outcome<Image> contact_sheet(const SheetLayout& layout, std::span<const Image> cells) {
    if (cells.empty()) return Failure{"a sheet needs at least one picture"};
    const int width = cells.front().width, height = cells.front().height;
    const Outcome<Grid> made = grid_of(layout, cells.size(), width, height);
    if (!made) return Failure{made.error};
    const Grid& grid = made.value;
    Image sheet = make_image(grid.width, grid.height, kPaper[0], kPaper[1], kPaper[2]);
    std::string error;
    const auto label = [&](const std::vector<std::string>& labels, std::size_t index, int room, int x, int y,
                           bool is_centered) {
        if (index >= labels.size()) return;
        const Outcome<Lettering> text = lettering_within(labels[index], grid.text, room);
        if (!text)
            error = text.error;
        else
            put(sheet, text.value, is_centered ? x + (room - text.value.width) / 2 : x, y, kInk);
    };
    const std::size_t columns = std::size_t(std::max(layout.columns, 1));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t column = i % columns, row = i / columns;
        const int x = grid.left + kGap + int(column) * grid.step_x;
        int y = grid.top + kGap + int(row) * grid.step_y;
        if (row == 0) label(layout.column_labels, column, width, x, kGap / 2, true);
        if (column == 0) label(layout.row_labels, row, grid.left - 2 * kGap, kGap, y + (height - grid.line) / 2, false);
        if (!layout.cell_labels.empty()) {
            label(layout.cell_labels, i, width, x, y, true);
            y += grid.line;
        }
        copy(cells[i], sheet, x, y);
    }
    if (!error.empty()) return Failure{error};
    return sheet;
}

}  // namespace patina::runtime
