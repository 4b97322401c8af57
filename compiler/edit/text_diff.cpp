#include "patina/text_diff.h"

#include <algorithm>

namespace patina {
namespace {

using Lines = std::vector<std::string_view>;
using Kind = DiffLine::Kind;

Lines lines_of(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text = end == text.npos ? std::string_view() : text.substr(end + 1);
    }
    return lines;
}

constexpr int kMostSteps = 2000;  // differences; a step keeps as many numbers

// Whether each line is a part of both, from the furthest points that each number of differences reaches on each
// diagonal of the grid of both texts. With more differences than the limit, none is.
void find_common(const Lines& a, const Lines& b, std::vector<bool>& kept_a, std::vector<bool>& kept_b) {
    const int n = int(a.size()), m = int(b.size());
    std::vector<std::vector<int>> history;  // x of diagonal k at [k + d]
    std::vector<int> reach(std::size_t(2 * kMostSteps + 3), 0);
    const auto at = [&](int k) -> int& { return reach[std::size_t(k + kMostSteps + 1)]; };
    for (int d = 0; d <= std::min(n + m, kMostSteps); d++) {
        for (int k = -d; k <= d; k += 2) {
            int x = k == -d || (k != d && at(k - 1) < at(k + 1)) ? at(k + 1) : at(k - 1) + 1;
            while (x < n && x - k < m && x - k >= 0 && a[std::size_t(x)] == b[std::size_t(x - k)]) x++;
            at(k) = x;
            if (x < n || x - k < m) continue;
            // Back from the end to the beginning.
            for (int step = d, diagonal = k; step >= 0; step--) {
                int from_x = 0, from_k = 0;
                if (step > 0) {
                    const std::vector<int>& before = history[std::size_t(step - 1)];
                    const auto had = [&](int j) { return before[std::size_t(j + step)]; };
                    from_k = diagonal == -step || (diagonal != step && had(diagonal - 1) < had(diagonal + 1))
                                 ? diagonal + 1
                                 : diagonal - 1;
                    from_x = had(from_k);
                }
                const int start = step == 0 ? 0 : from_k == diagonal + 1 ? from_x : from_x + 1;
                for (int each = start; each < x; each++) {
                    kept_a[std::size_t(each)] = true;
                    kept_b[std::size_t(each - diagonal)] = true;
                }
                x = from_x;
                diagonal = from_k;
            }
            return;
        }
        std::vector<int> row;
        for (int k = -d - 1; k <= d + 1; k++) row.push_back(at(k));
        history.push_back(std::move(row));
    }
}

}  // namespace

std::vector<DiffLine> all_lines(std::string_view old_text, std::string_view new_text) {
    const Lines a = lines_of(old_text), b = lines_of(new_text);
    std::vector<bool> kept_a(a.size()), kept_b(b.size());
    find_common(a, b, kept_a, kept_b);
    std::vector<DiffLine> all;
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        if (i < a.size() && !kept_a[i]) {
            all.push_back({Kind::Removed, int(i + 1), 0, std::string(a[i])});
            i++;
        } else if (j < b.size() && !kept_b[j]) {
            all.push_back({Kind::Added, 0, int(j + 1), std::string(b[j])});
            j++;
        } else {
            all.push_back({Kind::Same, int(i + 1), int(j + 1), std::string(a[i])});
            i++, j++;
        }
    }
    return all;
}

std::vector<DiffLine> differences(std::string_view old_text, std::string_view new_text) {
    if (old_text == new_text) return {};
    std::vector<DiffLine> all = all_lines(old_text, new_text);
    std::vector<bool> shown(all.size());
    for (int i = 0; i < int(all.size()); i++) {
        if (all[std::size_t(i)].kind == Kind::Same) continue;
        for (int near = std::max(i - kDiffContext, 0); near <= std::min(i + kDiffContext, int(all.size()) - 1); near++)
            shown[std::size_t(near)] = true;
    }
    std::vector<DiffLine> result;
    for (std::size_t i = 0; i < all.size(); i++) {
        if (shown[i])
            result.push_back(std::move(all[i]));
        else if (i == 0 || shown[i - 1])
            result.push_back({.kind = Kind::Gap});
    }
    return result;
}

std::size_t changed_lines(const std::vector<DiffLine>& diff) {
    return std::size_t(std::count_if(diff.begin(), diff.end(), [](const DiffLine& line) {
        return line.kind == Kind::Added || line.kind == Kind::Removed;
    }));
}

}  // namespace patina
