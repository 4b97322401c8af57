// The public face: one linked stage, its inputs, outputs, blocks and textures by name.
#include <algorithm>
#include <cstring>

#include "compiler/base/bits.h"
#include "compiler/interpret/machine.h"
#include "compiler/interpret/trace.h"
#include "compiler/link/program.h"
#include "patina/interpret.h"

namespace patina {

using interpret::Machine;

namespace {

std::string_view builtin_name(ir::Builtin builtin) {
    switch (builtin) {
        case ir::Builtin::None: return "";
        case ir::Builtin::Position: return "position";
        case ir::Builtin::FragCoord: return "fragCoord";
        case ir::Builtin::FrontFacing: return "frontFacing";
        case ir::Builtin::VertexIndex: return "vertexIndex";
        case ir::Builtin::InstanceIndex: return "instanceIndex";
    }
    return "";
}

std::vector<StageValue> stage_values(const std::vector<ir::StageVariable>& variables) {
    std::vector<StageValue> values;
    for (const ir::StageVariable& variable : variables) {
        const bool is_builtin = variable.builtin != ir::Builtin::None;
        values.push_back({.name = is_builtin ? std::string(builtin_name(variable.builtin)) : variable.name,
                          .components = variable.type.components(),
                          .is_builtin = is_builtin,
                          .is_flat = variable.flat || variable.type.is_integer()});
    }
    return values;
}

// --- bytes of a block -> components, as std140 lays them out

constexpr std::size_t kColumnStride = 16;

class BlockReader {
public:
    BlockReader(const ir::Module& module, const ir::UniformBlock& block, std::span<const std::byte> bytes)
        : module_(module), block_(block), bytes_(bytes) {}

    // Appends the components of a value at `offset`, in the order of Resources::uniforms; what is beyond the end is 0.
    void read(ir::Type type, std::size_t offset, std::vector<double>& into) const {
        if (type.is_numeric()) return read_numeric(type, offset, into);
        if (type.kind != ir::Kind::Array) return;  // blocks hold numbers and arrays of numbers
        const ir::Array& array = module_.arrays[type.ref];
        for (std::uint32_t i = 0; i < array.count; ++i) read(array.element, offset + i * stride(array.element), into);
    }

private:
    std::size_t stride(ir::Type element) const {
        return element.is_matrix() ? kColumnStride * element.cols : kColumnStride;
    }

    // A value holds a matrix by rows; a vector is one column.
    void read_numeric(ir::Type type, std::size_t offset, std::vector<double>& into) const {
        const bool by_rows = block_.matrices_by_rows && type.is_matrix();
        for (unsigned row = 0; row < type.rows; ++row) {
            for (unsigned column = 0; column < type.cols; ++column) {
                const unsigned vector = by_rows ? row : column, component = by_rows ? column : row;
                into.push_back(scalar(type.scalar, offset + vector * kColumnStride + component * sizeof(float)));
            }
        }
    }

    double scalar(ir::Scalar kind, std::size_t offset) const {
        std::uint32_t bits = 0;
        if (offset + sizeof bits > bytes_.size()) return 0;
        std::memcpy(&bits, bytes_.data() + offset, sizeof bits);
        switch (kind) {
            case ir::Scalar::Bool: return bits != 0 ? 1 : 0;
            case ir::Scalar::Int: return static_cast<std::int32_t>(bits);
            case ir::Scalar::Uint: return bits;
            case ir::Scalar::Half:  // a block has 32-bit members only
            case ir::Scalar::Float: return static_cast<double>(bits_as<float>(bits));
        }
        return 0;
    }

    const ir::Module& module_;
    const ir::UniformBlock& block_;
    std::span<const std::byte> bytes_;
};

}  // namespace

struct Interpreter::Impl {
    const Program* program = nullptr;
    const ir::Module* module = nullptr;  // null: the program has no such stage
    Machine machine;
    std::vector<StageValue> inputs, outputs;
};

Interpreter::Interpreter(const Program& program, std::string_view pass, Stage stage, Precision precision)
    : impl_(std::make_unique<Impl>()) {
    const auto found = std::find_if(program.stages.begin(), program.stages.end(), [&](const ProgramStage& candidate) {
        return candidate.pass == pass && candidate.stage == stage;
    });
    if (found == program.stages.end()) return;
    impl_->program = &program;
    impl_->module = &found->module;
    impl_->machine = interpret::make_machine(found->module, found->module.stage.entry, precision);
    impl_->machine.is_quad = stage == Stage::Fragment;
    impl_->inputs = stage_values(found->module.stage.inputs);
    impl_->outputs = stage_values(found->module.stage.outputs);
}

Interpreter::~Interpreter() = default;
Interpreter::Interpreter(Interpreter&&) noexcept = default;

const std::vector<StageValue>& Interpreter::inputs() const {
    return impl_->inputs;
}

const std::vector<StageValue>& Interpreter::outputs() const {
    return impl_->outputs;
}

void Interpreter::set_block(std::string_view name, std::span<const std::byte> bytes) {
    if (!impl_->module) return;
    const ir::Module& module = *impl_->module;
    std::vector<double> components;
    for (std::uint32_t i = 0; i < module.globals.size(); ++i) {
        const ir::Global& global = module.globals[i];
        if (!global.in_block() || module.blocks[global.block].name != name) continue;
        components.clear();
        const std::size_t offset = module.blocks[global.block].members[global.member].offset;
        BlockReader(module, module.blocks[global.block], bytes).read(global.type, offset, components);
        interpret::set_uniform(impl_->machine, module, ir::GlobalId{i}, components);
    }
}

void Interpreter::set_value(std::string_view name, std::span<const double> components) {
    if (!impl_->module) return;
    const ir::Module& module = *impl_->module;
    for (std::uint32_t i = 0; i < module.globals.size(); ++i) {
        const ir::Global& global = module.globals[i];
        if ((global.in_block() || global.is_keyword()) && global.name == name)
            interpret::set_uniform(impl_->machine, module, ir::GlobalId{i}, components);
    }
}

// A texture brings its sampler's state: the sampler behind it is bound with it.
void Interpreter::set_texture(std::string_view name, std::shared_ptr<const TextureData> texture) {
    if (!impl_->module) return;
    const std::vector<ir::Global>& globals = impl_->module->globals;
    const auto is_texture = [&](const ir::Global& global) { return global.name == name && global.type.is_texture(); };
    const auto found = std::find_if(globals.begin(), globals.end(), is_texture);
    if (found == globals.end()) return;
    const auto index = static_cast<std::uint32_t>(found - globals.begin());
    interpret::set_texture(impl_->machine, ir::GlobalId{index}, texture);
    if (index + 1 < globals.size() && globals[index + 1].type.kind == ir::Kind::Sampler)
        interpret::set_texture(impl_->machine, ir::GlobalId{index + 1}, texture);
}

void Interpreter::set_sampler(std::string_view name, const Sampler& sampler) {
    if (!impl_->module) return;
    const std::vector<ir::Global>& globals = impl_->module->globals;
    for (std::uint32_t i = 0; i < globals.size(); ++i) {
        if (globals[i].name != name || globals[i].type.kind != ir::Kind::Sampler) continue;
        // Only its state is read.
        impl_->machine.textures[i] = std::make_shared<const TextureData>(TextureData{.levels = {}, .sampler = sampler});
    }
}

std::vector<TracedValue> Interpreter::trace(const QuadInputs& quad, unsigned lane) {
    if (!impl_->module) return {};
    interpret::Watcher watcher{.lane = lane};
    impl_->machine.watcher = &watcher;
    run(quad);
    impl_->machine.watcher = nullptr;
    return interpret::traced_values(*impl_->program, *impl_->module, impl_->machine, watcher.sightings);
}

QuadOutputs Interpreter::run(const QuadInputs& quad) {
    QuadOutputs outputs;
    if (!impl_->module) return outputs;
    Machine& machine = impl_->machine;
    for (unsigned lane = 0; lane < interpret::kLanes; ++lane) {
        const std::vector<double>& values = quad.lanes[lane];
        for (std::size_t i = 0; i < machine.argument_types.size(); ++i) {
            machine.set_argument(i, lane, i < values.size() ? values[i] : 0);
        }
    }
    machine.steps_left = kMostSteps;
    try {
        interpret::execute(machine);
    } catch (const interpret::OutOfSteps&) {
        outputs.is_over_budget = true;
    }
    for (unsigned lane = 0; lane < interpret::kLanes; ++lane) {
        outputs.lanes[lane].resize(machine.output.count);
        for (std::size_t i = 0; i < machine.output.count && !outputs.is_over_budget; ++i)
            outputs.lanes[lane][i] = machine.result(i, lane);
        outputs.discarded[lane] = (machine.discarded >> lane & 1) != 0;
    }
    return outputs;
}

}  // namespace patina
