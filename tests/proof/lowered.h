// A material as IR functions: what the compiler has before a pass is linked, for proofs about the functions of a
// lighting model. Sources and options live as long as it does.
//
//   LoweredMaterial made(material_of("lambert", "metallic-roughness"));
//   made.slot("direct");
#pragma once

#include <memory>
#include <string>

#include "compiler/lower/lower.h"

namespace patina::proof {

// A material that is given nothing.
std::string material_of(std::string_view model, std::string_view workflow);

class LoweredMaterial {
public:
    // `path`: of the graph's file, or any name if `text` does not need it to find others. Fails the test, and is not
    // ok(), if there are errors.
    explicit LoweredMaterial(std::string text, const std::string& path = "proof.graph.json",
                             ir::BuildOptions build = {}, const std::string& rendering_path = "forward");

    bool ok() const { return ok_; }
    ir::Module& module() { return lowered_.module; }
    lower::Lowered& lowered() { return lowered_; }
    const resolve::Material& material() const { return *material_; }
    // A function that the lighting graph fills in for the passes.
    ir::FunctionId slot(std::string_view name) const { return function(name); }
    // Null if there is none.
    ir::FunctionId function(std::string_view name) const;
    // Number of a member of the lighting surface.
    std::uint32_t surface_member(std::string_view name) const;

private:
    CompileOptions options_;
    resolve::Session session_;
    std::shared_ptr<format::Graph> graph_;
    std::unique_ptr<resolve::Material> material_;
    lower::Lowered lowered_;
    bool ok_ = false;
};

}  // namespace patina::proof
