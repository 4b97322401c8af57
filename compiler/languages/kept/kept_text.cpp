#include "compiler/languages/kept/kept_text.h"

#include <algorithm>

#include "compiler/ir/content/content.h"

namespace patina::languages {

using namespace ir;

namespace {

void add_texts(Content& content, std::span<const std::string> texts) {
    content.number(texts.size());
    for (const std::string& text : texts) content.text(text);
}

// Each struct is taken apart whole, so that a new member is not forgotten here.
void add_entry(Content& content, const Module& module, const EntryPoint& entry) {
    const auto& [signature, inputs, outputs, before_return, at_return, names, begin, guards, end] = entry;
    content.text(signature);
    content.number(inputs.size());
    for (const auto& [text, precedence] : inputs) {
        content.text(text);
        content.number(static_cast<std::uint64_t>(precedence));
    }
    add_texts(content, outputs);
    content.text(before_return);
    content.text(at_return);
    add_texts(content, names);
    add_texts(content, begin);
    add_texts(content, guards);
    add_texts(content, end);
    for (const auto* variables : {&module.stage.inputs, &module.stage.outputs}) {
        content.number(variables->size());
        for (const StageVariable& variable : *variables) content.variable(variable);
    }
}

// The numbers of things in the order of first mention.
class Order {
public:
    std::uint32_t operator()(std::uint32_t index) {
        const auto found = std::find(mentioned_.begin(), mentioned_.end(), index);
        const auto place = static_cast<std::uint32_t>(found - mentioned_.begin());
        if (found == mentioned_.end()) mentioned_.push_back(index);
        return place;
    }
    const std::vector<std::uint32_t>& mentioned() const { return mentioned_; }

private:
    std::vector<std::uint32_t> mentioned_;
};

// All that the text is made of, but for the names that are taken around it.
void add_function(Content& content, const Writer& w, FunctionId id, const EntryPoint* entry) {
    content.text(w.language.name);
    content.number(w.options.width);
    content.number(static_cast<std::uint64_t>(w.module.stage.kind) | std::uint64_t{entry != nullptr} << 8 |
                   std::uint64_t{w.module.tests_keywords} << 9 | std::uint64_t{w.options.taken != nullptr} << 10);
    if (w.options.taken) add_texts(content, w.options.taken->prefixes);
    if (entry) add_entry(content, w.module, *entry);
    content.text(w.functions[id.index]);
    add_texts(content, w.helpers[id.index]);
    Order callees, globals;
    content.function(
        w.module[id], [&](std::uint32_t i) { return callees(i); }, [&](std::uint32_t i) { return globals(i); });
    for (const std::uint32_t i : callees.mentioned()) {
        const Function& callee = w.module.functions[i];
        content.text(w.functions[i]);
        content.text(callee.name);
        content.text(callee.spelling);
        content.number(static_cast<std::uint64_t>(callee.linkage));
    }
    for (const std::uint32_t i : globals.mentioned()) {
        const Global& global = w.module.globals[i];
        content.text(w.globals[i]);
        content.global(global);
        if (global.is_keyword()) content.keyword(w.module.keywords[global.keyword]);
        if (!global.in_block()) continue;
        content.number(w.module.blocks[global.block].matrices_by_rows);
        content.member(w.module.blocks[global.block].members[global.member]);
        content.text(w.blocks[global.block]);
    }
    for (std::size_t i = 0; i < content.structs().size(); ++i) {
        const std::uint32_t index = content.structs()[i];
        content.text(w.structs[index]);
        add_texts(content, w.members[index]);
    }
}

void append(Writer& w, const KeptText& kept, const std::vector<OriginId>& origins) {
    const int first = w.next_line;
    for (const PrintedLine& line : kept.lines) {
        const OriginId origin = line.origin ? origins[line.origin.index] : OriginId{};
        const bool changes = w.lines.empty() ? static_cast<bool>(origin) : w.lines.back().origin != origin;
        if (changes) w.lines.push_back({first + line.line, origin});
    }
    for (const int line : kept.light_loops) w.light_loops.push_back(first + line);
    w.text += kept.text;
    w.next_line += static_cast<int>(std::count(kept.text.begin(), kept.text.end(), '\n'));
}

// What has been printed since `begin`, which is the line `first_line` and the entry `first` of the writer's lines.
KeptText kept_of(const Writer& w, std::size_t begin, std::size_t first, int first_line, OriginId before,
                 const std::vector<OriginId>& origins, Names::Asked asked) {
    KeptText kept{.text = w.text.substr(begin), .lines = {}, .light_loops = {}, .asked = std::move(asked)};
    const auto add = [&](int line, OriginId origin) {
        const auto place = std::find(origins.begin(), origins.end(), origin) - origins.begin();
        kept.lines.push_back({line, origin ? OriginId{static_cast<std::uint32_t>(place)} : origin});
    };
    if (first == w.lines.size() || w.lines[first].line != first_line) add(0, before);
    for (std::size_t i = first; i < w.lines.size(); ++i) add(w.lines[i].line - first_line, w.lines[i].origin);
    for (const int line : w.light_loops)
        if (line >= first_line) kept.light_loops.push_back(line - first_line);
    return kept;
}

}  // namespace

void print_kept(Writer& w, FunctionId id, const EntryPoint* entry, const std::function<void()>& print) {
    Content& content = w.content ? *w.content : w.content.emplace(w.module);
    content.restart();
    add_function(content, w, id, entry);
    const auto [kept, is_asked_again] = w.options.kept->ask(content.bytes());
    if (kept && w.names.would_answer(kept->asked)) return append(w, *kept, content.origins());
    if (kept || !is_asked_again) return print();  // a kept one was printed among other names, and stays
    const std::size_t begin = w.text.size(), first = w.lines.size();
    const int first_line = w.next_line;
    const OriginId before = w.lines.empty() ? OriginId{} : w.lines.back().origin;
    Names::Asked asked;
    w.names.note_into(&asked);
    print();
    w.names.note_into(nullptr);
    KeptText made = kept_of(w, begin, first, first_line, before, content.origins(), std::move(asked));
    constexpr std::size_t kNode = 96;  // of `asked`, with its name
    const std::size_t bytes = made.text.size() + sizeof(PrintedLine) * made.lines.size() + kNode * made.asked.size();
    w.options.kept->keep(content.take(), std::move(made), bytes);
}

}  // namespace patina::languages
