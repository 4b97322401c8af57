// Finds what the passes of one file share, and the pieces of the include that they need.
#include <algorithm>
#include <map>

#include "compiler/base/text.h"
#include "compiler/writers/shaderlab/shader_file.h"
#include "compiler/writers/shaderlab/share_samplers.h"

namespace patina::writers::shaderlab {
namespace {

using Declaration = PassText::Declaration;
using Kind = languages::Piece::Kind;

// The names that a piece defines: the words before the first '(' in lines without indentation.
std::vector<std::string_view> names_of(std::string_view piece) {
    std::vector<std::string_view> names;
    for (const std::string_view line : split(piece, "\n")) {
        const std::size_t open = line.find('(');
        const bool is_macro = line.starts_with("#define ");
        const bool is_call = line.ends_with(';');  // of a macro that declares something
        if (open == line.npos || is_call || line.starts_with("//") || line.starts_with(" ") ||
            (line.starts_with("#") && !is_macro))
            continue;
        const std::string_view before = line.substr(0, open);
        names.push_back(before.substr(before.rfind(' ') + 1));
    }
    return names;
}

}  // namespace

std::vector<std::string_view> needed_pieces_of(std::string_view include, const std::string& text) {
    const std::vector<std::string_view> pieces = split(include, "\n\n");
    std::vector<bool> is_needed(pieces.size());
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (is_needed[i]) continue;
            for (const std::string_view name : names_of(pieces[i])) {
                bool is_read = mentions(text, name);
                for (std::size_t k = 0; k < pieces.size(); ++k)
                    is_read = is_read || (is_needed[k] && mentions(pieces[k], name));
                if (!is_read || is_needed[i]) continue;
                is_needed[i] = grows = true;
            }
        }
    }
    std::vector<std::string_view> made;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (is_needed[i]) made.push_back(pieces[i]);
    }
    return made;
}

namespace {

// True for the types that entry functions take and return, which may have the same name in all passes.
bool is_of_entry(const PassText& pass, const Declaration& each) {
    if (each.kind == Kind::Entry) return true;
    const std::string& fragment = pass.declarations.back().text;
    return each.kind == Kind::Struct && mentions(fragment.substr(0, fragment.find('\n')), each.name);
}

// For each name, the text that most passes have. Declarations of single passes are left out.
std::map<std::string_view, const Declaration*> most_common(const std::vector<PassText>& passes) {
    std::map<std::string_view, std::map<std::string_view, int>> counts;
    std::map<std::string_view, const Declaration*> made;
    for (const PassText& pass : passes) {
        for (const Declaration& each : pass.declarations) {
            if (is_of_entry(pass, each)) continue;
            const int count = ++counts[each.name][each.text];
            const Declaration*& best = made[each.name];
            if (!best || count > counts[each.name][best->text]) best = &each;
        }
    }
    return made;
}

// The text of the vertex function and its struct.
std::string vertex_text(const PassText& pass) {
    std::string text;
    for (const Declaration& each : pass.declarations) {
        if (each.is_of_vertex) text += each.text;
    }
    return text;
}

std::string_view condition_of(const PassText& pass) {
    for (const ir::StageText& text : pass.texts) {
        if (text.place == "vertex condition") return text.line;
    }
    return {};
}

// The first vertex function that several passes have stands before all passes. If others have their own, a condition
// must hide it there, so it must not hold for these.
void share_vertex(std::vector<PassText>& passes) {
    for (const PassText& first : passes) {
        const std::string text = vertex_text(first);
        const auto is_same = [&](const PassText& each) {
            return vertex_text(each) == text && condition_of(each) == condition_of(first);
        };
        const auto is_hidden = [&](const PassText& each) {
            return is_same(each) || (!condition_of(first).empty() && condition_of(each).empty());
        };
        const auto count = std::count_if(passes.begin(), passes.end(), is_same);
        if (count < 2 || !std::all_of(passes.begin(), passes.end(), is_hidden)) continue;
        for (PassText& each : passes) each.shares_vertex = is_same(each);
        return;
    }
}

void mark_own(std::vector<PassText>& passes) {
    std::map<std::string, int> counts;
    for (const PassText& pass : passes) {
        for (const Declaration& each : pass.declarations) ++counts[each.name];
    }
    share_vertex(passes);
    for (PassText& pass : passes) {
        for (Declaration& each : pass.declarations)
            each.is_own = !(each.is_of_vertex && pass.shares_vertex) &&
                          (is_of_entry(pass, each) || (each.kind != Kind::Uniform && counts[each.name] == 1));
    }
}

}  // namespace

std::vector<ir::Origin> origins_of(std::span<const LinkedPass> passes) {
    std::vector<ir::Origin> all;
    for (const LinkedPass& pass : passes) {
        for (const ir::Module* stage : {&pass.fragment, &pass.vertex})
            all.insert(all.end(), stage->origins.begin(), stage->origins.end());
    }
    return all;
}

std::vector<PassText> pass_texts(std::span<const LinkedPass> linked, const engines::Engine& engine) {
    std::vector<PassText> passes;
    std::vector<std::vector<std::string>> taken(linked.size());
    const languages::TakenNames engine_names = taken_names(engine.names);
    const SamplerUse samplers = sampler_use(linked, engine.most_samplers);
    for (const LinkedPass& pass : linked) passes.push_back(pass_text(pass, engine, engine_names, samplers, {}));
    for (bool differ = true; differ;) {
        differ = false;
        const auto common = most_common(passes);
        for (std::size_t i = 0; i < linked.size(); ++i) {
            const std::size_t before = taken[i].size();
            for (const Declaration& each : passes[i].declarations) {
                if (!is_of_entry(passes[i], each) && common.at(each.name)->text != each.text)
                    taken[i].push_back(each.name);
            }
            differ = differ || taken[i].size() > before;
        }
        for (std::size_t i = 0; differ && i < linked.size(); ++i)
            passes[i] = pass_text(linked[i], engine, engine_names, samplers, taken[i]);
    }
    mark_own(passes);
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < linked.size(); ++i) {
        for (Declaration& each : passes[i].declarations) {
            for (languages::PrintedLine& line : each.lines) {
                if (line.origin) line.origin.index += first;
            }
        }
        first += static_cast<std::uint32_t>(linked[i].fragment.origins.size() + linked[i].vertex.origins.size());
    }
    return passes;
}

std::vector<const Declaration*> shared_declarations(const std::vector<PassText>& passes) {
    std::vector<const Declaration*> made;
    for (const PassText& pass : passes) {
        for (const Declaration& each : pass.declarations) {
            const auto is_same = [&](const Declaration* other) { return other->name == each.name; };
            if (!each.is_own && std::none_of(made.begin(), made.end(), is_same)) made.push_back(&each);
        }
    }
    std::stable_sort(made.begin(), made.end(), [](const Declaration* a, const Declaration* b) {
        return std::pair(a->is_of_vertex, a->kind) < std::pair(b->is_of_vertex, b->kind);
    });
    return made;
}

std::string_view vertex_condition(const std::vector<PassText>& passes) {
    const auto shares = [](const PassText& pass) { return pass.shares_vertex; };
    const auto first = std::find_if(passes.begin(), passes.end(), shares);
    return first == passes.end() || std::all_of(passes.begin(), passes.end(), shares) ? std::string_view()
                                                                                      : condition_of(*first);
}

}  // namespace patina::writers::shaderlab
