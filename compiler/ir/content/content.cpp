#include "compiler/ir/content/content.h"

#include "compiler/base/bits.h"

// A number comes first, and what it means follows where it is mentioned for the first time: so no two lists of parts
// have the same bytes. Each struct is taken apart whole, so that this file does not compile if a member is added to one
// and forgotten here.
namespace patina::ir {
namespace {

std::uint64_t both_ends(Span span) {
    return span.begin | std::uint64_t{span.end} << 32;
}

// True if it has not been mentioned before. From now on it has been.
bool mention(std::vector<std::uint32_t>& places, std::vector<std::uint32_t>& mentioned, std::uint32_t index) {
    if (places[index] != 0) return false;
    mentioned.push_back(index);
    places[index] = static_cast<std::uint32_t>(mentioned.size());
    return true;
}

void forget(std::vector<std::uint32_t>& places, std::vector<std::uint32_t>& mentioned) {
    for (const std::uint32_t index : mentioned) places[index] = 0;
    mentioned.clear();
}

}  // namespace

void Content::restart() {
    size_ = 0;
    forget(names_, mentioned_names_);
    forget(constants_, mentioned_constants_);
    forget(structs_, mentioned_structs_);
    forget(arrays_, mentioned_arrays_);
    for (const OriginId id : mentioned_) origins_[id.index] = 0;
    mentioned_.clear();
    spans_.clear();
    places_.clear();
}

void Content::declared_type(Type type) {
    const std::uint32_t ref = type.ref;
    const bool is_struct = type.kind == Kind::Struct;
    const bool is_new =
        is_struct ? mention(structs_, mentioned_structs_, ref) : mention(arrays_, mentioned_arrays_, ref);
    number(as_number(type, is_struct ? structs_[ref] : arrays_[ref]));
    if (is_new && is_struct) {
        const auto& [name, members] = module_.structs[ref];
        text(name);
        number(members.size());
        for (const auto& [member_name, member_type] : members) {
            text(member_name);
            this->type(member_type);
        }
    } else if (is_new) {
        const auto& [element, count] = module_.arrays[ref];
        this->type(element);
        number(count);
    }
}

void Content::variable(const StageVariable& variable) {
    const auto& [name, of, location, builtin, semantic, flat, from_bottom, spelling, guard] = variable;
    text(name);
    type(of);
    number(location | static_cast<std::uint64_t>(builtin) << 32 | std::uint64_t{flat} << 40 |
           std::uint64_t{from_bottom} << 41);
    text(semantic);
    text(spelling);
    text(guard);
}

void Content::global(const Global& global) {
    const auto& [name, of, block, member, keyword, group, place, unused_span, spelling, decoder, follower, at_once,
                 is_of_object, from_bottom] = global;
    static_cast<void>(unused_span);
    text(name);
    type(of);
    number(block | std::uint64_t{member} << 32);
    number(keyword | static_cast<std::uint64_t>(group) << 32 | std::uint64_t{is_of_object} << 40 |
           std::uint64_t{from_bottom} << 41);
    const auto& [set, binding, slot] = place;
    number(set | std::uint64_t{binding} << 32);
    number(slot);
    text(spelling);
    text(decoder);
    text(follower);
    text(at_once);
}

void Content::block(const UniformBlock& block) {
    const auto& [name, group, place, matrices_by_rows, size, members] = block;
    text(name);
    number(static_cast<std::uint64_t>(group) | std::uint64_t{matrices_by_rows} << 8 | std::uint64_t{size} << 32);
    number(place.set | std::uint64_t{place.binding} << 32);
    number(place.slot);
    number(members.size());
    for (const BlockMember& each : members) member(each);
}

void Content::member(const BlockMember& member) {
    const auto& [name, of, offset, padding, stored_as, is_of_instance, declared_in] = member;
    text(name);
    type(of);
    number(offset | std::uint64_t{padding} << 32);
    number(is_of_instance);
    text(stored_as);
    text(declared_in);
}

void Content::keyword(const Keyword& keyword) {
    const auto& [property, constant_id, value, values] = keyword;
    text(property);
    number(constant_id ? 1 + std::uint64_t{*constant_id} : 0);
    number(bits_as<std::uint64_t>(value));
    number(values.size());
    for (const std::string& each : values) text(each);
}

void Content::texts(const std::vector<StageText>& texts) {
    number(texts.size());
    for (const auto& [place, line] : texts) {
        text(place);
        text(line);
    }
}

void Content::raw(const void* data, std::size_t size) {
    if (size == 0) return;
    if (size_ + size > room_) grow(size);
    std::memcpy(&bytes_[size_], data, size);
    size_ += size;
}

void Content::grow(std::size_t more) {
    room_ = 4 * (size_ + more) + 4096;
    std::unique_ptr<char[]> longer(new char[room_]);  // make_unique would fill it
    if (size_ > 0) std::memcpy(longer.get(), bytes_.get(), size_);
    bytes_ = std::move(longer);
}

void Content::signature(const Function& function) {
    const auto& [name, params, result, insts, operands, unused_blocks, made_by, comment, result_docs, always_inline,
                 inline_if_shorter, linkage, spelling, lines, is_of_object, code, unused_probes] = function;
    static_cast<void>(operands);
    static_cast<void>(unused_blocks);
    static_cast<void>(unused_probes);  // only functions that nothing tidies have any
    text(name);
    number(params.size());
    for (const auto& [param_name, of, rate, is_semantic, from_bottom, is_unit] : params) {
        text(param_name);
        type(of);
        number(static_cast<std::uint64_t>(rate) | std::uint64_t{is_semantic} << 8 | std::uint64_t{from_bottom} << 16 |
               std::uint64_t{is_unit} << 24);
    }
    type(result);
    const bool is_new_origin = is_new(made_by);
    number(made_by ? origins_[made_by.index] : 0);
    if (is_new_origin) origin(made_by);
    text(comment);
    number(result_docs.size());
    for (const std::string& doc : result_docs) text(doc);
    number(std::uint64_t{always_inline} | std::uint64_t{inline_if_shorter} << 1 | std::uint64_t{is_of_object} << 2 |
           static_cast<std::uint64_t>(linkage) << 8);
    text(spelling);
    texts(lines);
    const auto& [helpers, parts] = code;
    number(helpers.size());
    for (const std::string& helper : helpers) text(helper);
    number(parts.size());
    for (const auto& [part, name_behind] : parts) {
        text(part);
        number(name_behind);
    }
    number(insts.size());
}

void Content::instruction(const Function& function, const Inst& inst, std::uint32_t data) {
    const auto& [op, is_light_loop, is_while, of, unused_first, operand_count, unused_data, from, hint] = inst;
    static_cast<void>(unused_first);
    static_cast<void>(unused_data);
    type(of);
    const bool is_new_constant = op == Op::Constant && mention(constants_, mentioned_constants_, data);
    const bool is_new_origin = is_new(from);
    const bool is_new_name = hint && mention(names_, mentioned_names_, hint.index);
    const std::uint32_t words[] = {
        static_cast<std::uint32_t>(op) | std::uint32_t{is_light_loop} << 16 | std::uint32_t{is_while} << 17,
        operand_count, op == Op::Constant ? constants_[data] : data, from ? origins_[from.index] : 0,
        hint ? names_[hint.index] : 0};
    put(words);
    const std::span<const Value> args = function.args(inst);
    static_assert(sizeof(Value) == sizeof(std::uint32_t));
    if (!args.empty()) raw(args.data(), args.size_bytes());
    if (is_new_constant) constant(data);
    if (is_new_origin) origin(from);
    if (is_new_name) text(module_.names[hint.index]);
}

void Content::blocks(const Function& function) {
    number(function.blocks.size());
    for (const auto& [insts] : function.blocks) {
        number(insts.size());
        if (!insts.empty()) raw(insts.data(), insts.size() * sizeof(Value));
    }
}

void Content::constant(std::uint32_t index) {
    const auto& [of, unused_first] = module_.constants[index];
    static_cast<void>(unused_first);
    type(of);
    const std::span<const double> numbers = module_.numbers_of(module_.constants[index]);
    raw(numbers.data(), numbers.size_bytes());
}

bool Content::is_new(OriginId id) {
    if (!id || origins_[id.index] != 0) return false;
    mentioned_.push_back(id);
    origins_[id.index] = static_cast<std::uint32_t>(mentioned_.size());
    return true;
}

void Content::origin(OriginId id) {
    const auto& [label, is_note, path, function_path, where] = module_.origins[id.index];
    text(label);
    text(path);
    number(std::uint64_t{is_note} | std::uint64_t{function_path} << 32);
    const auto [found, is_new_span] = places_.try_emplace(both_ends(where), static_cast<std::uint32_t>(spans_.size()));
    if (is_new_span) spans_.push_back(where);
    number(found->second);
}

std::optional<std::uint32_t> Content::place_of(Span span) const {
    const auto found = places_.find(both_ends(span));
    return found == places_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace patina::ir
