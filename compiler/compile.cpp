// READ FIRST. The steps of a compilation, in order. Each takes what the steps before it have made, and says whether the
// next one may run. The room that does the work is named at each line.
//
//   text -> JSON -> graph -> material -> IR functions -> linked stages -> tidied stages -> texts and the reflection
#include "compiler/api/compilation.h"

namespace patina {

bool compile(Compilation& c) {
    return accept(c)             // writers: can the engine's files express the request?
           && find_path(c)       // resolve, paths: the rendering path, and the passes that it has
           && read_material(c)   // json, format, resolve: text -> graph; files, nodes, ports, circles, properties
           && lower_material(c)  // lower, emit: every node becomes a call, and types are checked
           && lower_passes(c)    // lower: the passes that the material adds, each a material of its own
           && link_materials(c)  // link: names of the interface are settled, and semantics become parameters
           && link_stages(c)     // link, ir/passes: two stages a pass; inlined, hoisted, pruned
           && check_stages(c)    // link: every value that a stage reads is there, and no limit is exceeded
           && order_passes(c)    // writers: the order in which the file holds them
           && reflect(c)         // output: what a runtime must know of all this
           && check_files(c)     // writers: what the file format cannot express
           && write_files(c)     // writers, output, languages: rewritten for the language, and printed
           && keep_programs(c);  // lower, link: the same without folding, for the CPU reference
}

}  // namespace patina
