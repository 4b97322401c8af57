#include <fmt/format.h>

#include <algorithm>

#include "compiler/cli/diff/report.h"

namespace patina::cli {
namespace {

constexpr std::size_t kWidest = 100;  // of a value, in bytes

class Printer {
public:
    explicit Printer(bool colors) : colors_(colors) {}

    std::string print(const DiffReport& report) {
        line(kBold, fmt::format("{} -> {}", report.before, report.after));
        if (report.graph.changes.empty()) line("", "no change in meaning");
        print_changes(report.graph.changes);
        if (report.has_shaders) print_shaders(report.shaders);
        if (const std::optional<PictureChange>& picture = report.picture) {
            title("picture");
            line("", fmt::format("  {:.2g} % of the pixels differ, by at most {:.3g}: {}", 100 * picture->share,
                                 picture->largest, picture->path));
        }
        return std::move(out_);
    }

private:
    static constexpr const char* kBold = "1";
    static constexpr const char* kRed = "31";
    static constexpr const char* kGreen = "32";
    static constexpr const char* kCyan = "36";

    void line(std::string_view color, std::string_view text) {
        if (colors_ && !color.empty()) {
            out_ += fmt::format("\x1b[{}m{}\x1b[0m\n", color, text);
        } else {
            out_ += fmt::format("{}\n", text);
        }
    }
    void title(std::string_view text) {
        out_ += '\n';
        line(kBold, text);
    }

    // "rust.in.level" below the title "nodes".
    static std::string name_of(const GraphChange& change) {
        const std::size_t first = is_listed(change) ? 1 : 0;
        std::string name;
        for (std::size_t i = first; i < change.path.size(); ++i) name += (name.empty() ? "" : ".") + change.path[i];
        return name;
    }
    static bool is_listed(const GraphChange& change) { return change.path.size() > 1; }
    static std::string shown(const std::string& value) {
        if (value.size() <= kWidest) return value;
        std::size_t cut = kWidest;
        while (cut > 0 && (static_cast<unsigned char>(value[cut]) & 0xC0u) == 0x80u) --cut;
        return value.substr(0, cut) + "...";
    }

    void print_change(const GraphChange& change) {
        const std::string name = name_of(change);
        switch (change.kind) {
            case GraphChangeKind::Added: return line(kGreen, fmt::format("  + {}: {}", name, shown(change.after)));
            case GraphChangeKind::Removed: return line(kRed, fmt::format("  - {}: {}", name, shown(change.before)));
            case GraphChangeKind::Renamed:
                return line(kCyan, fmt::format("  > {} is called {} now", change.before, change.after));
            case GraphChangeKind::Reordered:
                return line(kCyan, fmt::format("  > another order: {}", shown(change.after)));
            case GraphChangeKind::Changed:
                return line("", fmt::format("  {}: {} -> {}", name, shown(change.before), shown(change.after)));
        }
    }

    void print_changes(const std::vector<GraphChange>& changes) {
        std::vector<std::string> titles;
        const auto title_of = [](const GraphChange& change) {
            const bool is_list = is_listed(change) || change.kind == GraphChangeKind::Reordered;
            return is_list ? change.path.front() : std::string("graph");
        };
        for (const GraphChange& change : changes) {
            if (std::ranges::find(titles, title_of(change)) == titles.end()) titles.push_back(title_of(change));
        }
        for (const std::string& each : titles) {
            title(each);
            for (const GraphChange& change : changes) {
                if (title_of(change) == each) print_change(change);
            }
        }
    }

    static std::string name_of(const ShaderChange& shader) {
        const std::string language = shader.target.name();
        if (shader.pass.empty()) return language;
        return fmt::format("{}, {} stage, {}", shader.pass, to_string(shader.stage), language);
    }

    void print_shaders(const std::vector<ShaderChange>& shaders) {
        title("shaders");
        if (shaders.empty()) line("", "  no shader changed");
        for (const ShaderChange& shader : shaders) {
            const std::string name = name_of(shader);
            if (!shader.was_there) {
                line(kGreen, fmt::format("  + {}{}", name, instructions_of(shader.after)));
            } else if (!shader.is_there) {
                line(kRed, fmt::format("  - {}{}", name, instructions_of(shader.before)));
            } else {
                const char* same = shader.computes_same ? ", which computes the same" : "";
                line("", fmt::format("  {}: {} lines of text changed{}", name, changed_lines(shader.lines), same));
                if (shader.after != StageCost{}) print_cost(shader.before, shader.after);
                print_lines(shader.lines);
            }
        }
    }

    static std::string instructions_of(const StageCost& cost) {
        const std::uint32_t count = cost.total().instructions;
        return count == 0 ? std::string() : fmt::format(": {} instructions", count);
    }
    static std::string difference(std::uint32_t before, std::uint32_t after) {
        if (before == after) return fmt::format("{} as before", before);
        return fmt::format("{} -> {} ({:+})", before, after,
                           static_cast<std::int64_t>(after) - static_cast<std::int64_t>(before));
    }
    // The instructions, and what else is different.
    void print_cost(const StageCost& before, const StageCost& after) {
        const CostCounts old = before.total(), now = after.total();
        std::string text = fmt::format("    instructions: {}", difference(old.instructions, now.instructions));
        if (before.per_light.instructions + after.per_light.instructions > 0)
            text += fmt::format(", of them per light: {}",
                                difference(before.per_light.instructions, after.per_light.instructions));
        line("", text);
        text.clear();
        const auto add = [&](std::string_view what, std::uint32_t was, std::uint32_t is) {
            if (was != is) text += fmt::format("{}{}: {}", text.empty() ? "    " : ", ", what, difference(was, is));
        };
        add("arithmetic", old.arithmetic, now.arithmetic);
        add("transcendental", old.transcendental, now.transcendental);
        add("texture reads", old.textures, now.textures);
        add("derivatives", old.derivatives, now.derivatives);
        add("varyings", before.varyings, after.varyings);
        add("registers", before.registers, after.registers);
        if (!text.empty()) line("", text);
    }
    void print_lines(const std::vector<DiffLine>& lines) {
        for (const DiffLine& each : lines) {
            switch (each.kind) {
                case DiffLine::Kind::Same: line("", "      " + each.text); break;
                case DiffLine::Kind::Removed: line(kRed, "    - " + each.text); break;
                case DiffLine::Kind::Added: line(kGreen, "    + " + each.text); break;
                case DiffLine::Kind::Gap: line(kCyan, "    ..."); break;
            }
        }
    }

    bool colors_;
    std::string out_{};
};

}  // namespace

bool DiffReport::differs() const {
    return !graph.changes.empty() ||
           std::ranges::any_of(shaders, [](const ShaderChange& shader) { return !shader.computes_same; });
}

std::string report_text(const DiffReport& report, bool colors) {
    return Printer(colors).print(report);
}

}  // namespace patina::cli
