// A compiler that is made before `main`: the built-in library must be there by then, in whatever order the linker puts
// the initialisers.
#include <patina/patina.h>

#include <cstdio>

namespace {
const patina::Compiler compiler;
}

int main() {
    const patina::Result made = compiler.compile_text("plain.graph.json", R"({ "patina": 1, "workflow": "unlit" })");
    for (const patina::Diagnostic& d : made.diagnostics) std::fprintf(stderr, "%s\n", patina::to_text(d).c_str());
    std::printf("global %s, %zu shaders\n", compiler.node("Lerp") ? "Lerp" : "nothing", made.shaders.size());
    return made.ok ? 0 : 1;
}
