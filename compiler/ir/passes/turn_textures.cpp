#include <algorithm>
#include <array>
#include <utility>

#include "compiler/ir/hints.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"
#include "compiler/ir/texture_kinds.h"

namespace patina::ir {
namespace {

constexpr std::array kXY = {0u, 1u}, kZW = {2u, 3u};

bool samples(Op op) {
    return op == Op::Sample || op == Op::SampleBias || op == Op::SampleLevel || op == Op::SampleGrad;
}

// Rewrites one function. Old values are those of `from_`, new ones those of the copy.
class Turner {
public:
    Turner(Module& module, const Function& from, bool is_entry) : module_(module), from_(from), is_entry_(is_entry) {}

    Function run() {
        Function made = shell(from_);
        Builder builder(module_, made);
        Copy copy{.from = from_, .to = builder, .rewrite = [this](Copy& c, Value value) { return rewrite(c, value); }};
        raw_.resize(from_.insts.size());
        copy_body(copy);
        return made;
    }

private:
    // Values of the engine, whose y counts from the bottom.
    bool is_raw(const Inst& inst) const {
        if (inst.op == Op::Param) return from_.params[inst.data].from_bottom;
        return inst.op == Op::Global && module_.globals[inst.data].from_bottom;
    }

    bool rewrite(Copy& c, Value value) {
        const Inst& inst = from_[value];
        c.to.set_origin(inst.origin ? inst.origin : c.origin);
        if (is_raw(inst)) {
            const Value raw =
                inst.op == Op::Param ? c.to.param(inst.data) : c.to.emit(inst.op, inst.type, {}, inst.data);
            raw_[value.index] = raw;
            c.map[value.index] = inst.type.width() == 4 ? converted_tiling(c.to, raw) : turned(c.to, raw);
            return true;
        }
        if (inst.op == Op::Call) return rewrite_call(c, value);
        if (is_entry_ && inst.op == Op::Construct && inst.type == from_.result) return rewrite_outputs(c, value);
        if (inst.op != Op::TexelLoad && !samples(inst.op)) return false;
        const std::span<const Value> args = from_.args(inst);
        const TextureKind* texture = texture_kind(from_[args[0]].type.kind);
        if (!texture || !texture->has_rows) return false;
        std::vector<Value> operands = mapped(c, args);
        if (inst.op == Op::TexelLoad) {
            operands[1] = turned_texel(c.to, operands);
        } else {
            operands[2] = place(c, args[2]);
            for (std::size_t i = 3; inst.op == Op::SampleGrad && i < 5; ++i) operands[i] = gradient(c, args[i]);
        }
        return replaced(c, value, operands);
    }

    static std::vector<Value> mapped(const Copy& c, std::span<const Value> args) {
        std::vector<Value> operands;
        for (const Value arg : args) operands.push_back(c.map[arg.index]);
        return operands;
    }

    bool replaced(Copy& c, Value value, std::span<const Value> operands) {
        const Inst& inst = from_[value];
        c.map[value.index] = c.to.emit(inst.op, inst.type, operands, inst.data);
        c.to.name(c.map[value.index], inst.name);
        return true;
    }

    // Functions take such values as the engine has them.
    bool rewrite_call(Copy& c, Value value) {
        const std::vector<Param>& params = module_.functions[from_[value].data].params;
        std::vector<Value> operands = mapped(c, from_.args(from_[value]));
        bool changes = false;
        for (std::size_t i = 0; i < operands.size(); ++i) {
            if (!params[i].from_bottom) continue;
            operands[i] = coordinates(c, from_.args(from_[value])[i]);
            changes = true;
        }
        return changes && replaced(c, value, operands);
    }

    // So do interpolators.
    bool rewrite_outputs(Copy& c, Value value) {
        const std::span<const Value> args = from_.args(from_[value]);
        std::vector<Value> operands = mapped(c, args);
        for (std::size_t i = 0; i < operands.size(); ++i) {
            if (module_.stage.outputs[i].from_bottom) operands[i] = coordinates(c, args[i]);
        }
        return replaced(c, value, operands);
    }

    // --- the same place, counted from the bottom

    static Value turned(Builder& b, Value uv) {
        const Type scalar = b.type(uv).with_width(1);
        std::vector<Value> parts = {b.extract(uv, 0),
                                    b.emit(Op::Sub, scalar, {b.splat_constant(scalar, 1), b.extract(uv, 1)})};
        if (b.type(uv).width() == 3) parts.push_back(b.extract(uv, 2));
        const Hint hint = hint_of(b.module(), b[uv].name);
        const std::string_view said = hint.name.empty() ? hint.callee : hint.name;
        return named(b, b.construct(b.type(uv), parts), said.empty() ? "turnedUV" : std::string(said) + "Turned");
    }

    // A name for a value that needs one.
    static Value named(Builder& b, Value value, std::string_view name) {
        b.name(value, inlined_result(b.module(), name, {}));
        return value;
    }

    // v' = 1 - ((1 - v) s + o') is v s + o with o' = 1 - s - o.
    static Value converted_tiling(Builder& b, Value tiling) {
        const Type scalar = b.type(tiling).with_width(1);
        const Value rest = b.emit(Op::Sub, scalar, {b.splat_constant(scalar, 1), b.extract(tiling, 1)});
        const std::array parts = {b.extract(tiling, 0), b.extract(tiling, 1), b.extract(tiling, 2),
                                  b.emit(Op::Sub, scalar, {rest, b.extract(tiling, 3)})};
        return named(b, b.construct(b.type(tiling), parts), "turnedTiling");
    }

    static Value turned_texel(Builder& b, const std::vector<Value>& operands) {
        const Value size = b.emit(Op::TextureSize, Type::vector(Scalar::Int, 2), {operands[0], operands[2]});
        const Value last = b.emit(Op::Sub, kInt, {b.extract(size, 1), b.constant(kInt, {1})});
        const std::array parts = {b.extract(operands[1], 0), b.emit(Op::Sub, kInt, {last, b.extract(operands[1], 1)})};
        return b.construct(b.type(operands[1]), parts);
    }

    // Coordinates, alone or before the number of a layer.
    Value place(Copy& c, Value old) {
        const Inst& inst = from_[old];
        const std::span<const Value> args = from_.args(inst);
        const bool has_layer = inst.op == Op::Construct && args.size() == 2 && from_[args[0]].type.width() == 2;
        if (!has_layer) return coordinates(c, old);
        return c.to.construct(inst.type, std::array{coordinates(c, args[0]), c.map[args[1].index]});
    }

    // Two turns cancel: where the coordinates come from the engine, or from the engine and are scaled and moved by its
    // tiling.
    Value coordinates(Copy& c, Value old) {
        if (raw_[old.index]) return raw_[old.index];
        const Inst& inst = from_[old];
        if (inst.op == Op::Add) {
            const std::span<const Value> args = from_.args(inst);
            for (std::size_t i = 0; i < 2; ++i) {
                const Value tiling = tiling_of(args[1 - i], kZW);
                if (!tiling || from_[args[i]].op != Op::Mul) continue;
                const Value scaled = scaled_by(c, args[i], tiling);
                if (!scaled) continue;
                const Value made = c.to.emit(Op::Add, inst.type, {scaled, c.to.swizzle(tiling, kZW)});
                c.to.name(made, inst.name);
                return made;
            }
        }
        return turned(c.to, c.map[old.index]);
    }

    // uv * tiling.xy, as the engine counts; null if the product is something else.
    Value scaled_by(Copy& c, Value product, Value tiling) {
        const std::span<const Value> args = from_.args(from_[product]);
        for (std::size_t i = 0; i < 2; ++i) {
            if (tiling_of(args[1 - i], kXY) == tiling)
                return c.to.emit(Op::Mul, from_[product].type, {coordinates(c, args[i]), c.to.swizzle(tiling, kXY)});
        }
        return {};
    }

    // The tiling, as the engine has it, of which the old value is these two components.
    Value tiling_of(Value old, const std::array<unsigned, 2>& wanted) const {
        const Inst& inst = from_[old];
        if (inst.op != Op::Swizzle || inst.data != (wanted[0] | wanted[1] << 2)) return {};
        return raw_[from_.args(inst)[0].index];
    }

    // A difference of coordinates.
    Value gradient(Copy& c, Value old) {
        const Inst& inst = from_[old];
        if (inst.op == Op::Ddx || inst.op == Op::Ddy) {
            const Value of = from_.args(inst)[0];
            const Inst& product = from_[of];
            for (std::size_t i = 0; product.op == Op::Mul && i < 2; ++i) {
                const Value tiling = raw_tiling(from_.args(product)[i]);
                if (!tiling) continue;
                if (const Value scaled = scaled_by(c, of, tiling)) return c.to.emit(inst.op, inst.type, {scaled});
            }
            return c.to.emit(inst.op, inst.type, {coordinates(c, of)});
        }
        const Value made = c.map[old.index];
        std::vector<Value> parts = {c.to.extract(made, 0),
                                    c.to.emit(Op::Neg, c.to.type(made).with_width(1), {c.to.extract(made, 1)})};
        if (c.to.type(made).width() == 3) parts.push_back(c.to.extract(made, 2));
        return c.to.construct(c.to.type(made), parts);
    }

    Value raw_tiling(Value old) const { return tiling_of(old, kXY); }

    Module& module_;
    const Function& from_;
    bool is_entry_;
    std::vector<Value> raw_;  // by old value: what it is in the engine; null: it is no such value
};

// Finds parameters that functions may take in the engine's form: textures are read with them, and all callers have them
// from the engine. The turns of caller and function would cancel, but neither sees the other.
class Takers {
public:
    explicit Takers(Module& module) : module_(module), is_place_(module.functions.size()) {}

    void run() {
        for (std::uint32_t f = 0; f < module_.functions.size(); ++f) find_places(f);
        // From the last function to the first, so that all callers of a function are done before it.
        for (std::uint32_t f = static_cast<std::uint32_t>(module_.functions.size()); f-- > 0;) {
            Function& function = module_.functions[f];
            for (std::size_t i = 0; i < function.params.size(); ++i)
                function.params[i].from_bottom = function.params[i].from_bottom || is_place_[f][i];
            for (const Inst& inst : function.insts) {
                if (inst.op != Op::Call) continue;
                const std::span<const Value> args = function.args(inst);
                for (std::size_t i = 0; i < args.size(); ++i) {
                    if (!is_of_engine(function, args[i])) is_place_[inst.data][i] = false;
                }
            }
        }
    }

private:
    void find_places(std::uint32_t f) {
        const Function& function = module_.functions[f];
        is_place_[f].resize(function.params.size());
        if (is_elsewhere(function) || !module_.stage.entry || module_.stage.entry.index == f) return;
        const auto note = [&](Value value) {
            const Inst& inst = function[value];
            if (inst.op == Op::Param && inst.type.width() == 2) is_place_[f][inst.data] = true;
        };
        for (const Inst& inst : function.insts) {
            const std::span<const Value> args = function.args(inst);
            const TextureKind* texture = samples(inst.op) ? texture_kind(function[args[0]].type.kind) : nullptr;
            if (texture && texture->has_rows) note(args[2]);
            for (std::size_t i = 0; inst.op == Op::Call && i < args.size(); ++i) {
                if (is_place_[inst.data][i]) note(args[i]);
            }
        }
    }

    bool is_of_engine(const Function& function, Value value) const {
        const Inst& inst = function[value];
        if (inst.op == Op::Param) return function.params[inst.data].from_bottom;
        return inst.op == Op::Global && module_.globals[inst.data].from_bottom;
    }

    Module& module_;
    std::vector<std::vector<bool>> is_place_;  // by function and parameter
};

}  // namespace

Module turn_textures(Module module) {
    if (!module.has_values_from_bottom) return module;
    Takers(module).run();
    std::vector<Function> old = std::move(module.functions);
    module.functions = old;  // calls look up signatures here
    for (std::uint32_t i = 0; i < old.size(); ++i) {
        if (is_elsewhere(old[i])) continue;
        const bool is_entry = module.stage.entry && module.stage.entry.index == i;
        module.functions[i] = Turner(module, old[i], is_entry).run();
    }
    return module;
}

}  // namespace patina::ir
