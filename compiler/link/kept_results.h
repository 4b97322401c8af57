// What a compiler keeps of the compilations that it has done: stages that have been linked and tidied, and texts of
// functions. Materials differ in their surface; most of a shader is the library's, or its lighting model's. A key is
// all that a result was made of, as bytes: equal keys have equal results, so a kept result is never wrong and never too
// old.
//
//   KeptResults kept;
//   Session session(library, options);
//   session.kept = &kept;   // null: everything is made anew
#pragma once

#include "compiler/base/remembered.h"
#include "compiler/languages/kept/kept_text.h"

namespace patina::link {

// Equal functions come from other places of another graph's text.
struct KeptStage {
    ir::Module module;
    std::vector<std::uint32_t> places;  // by origin of the module: its span, by its place in Content::spans()
};

struct KeptResults {
    static constexpr std::size_t kMostBytes = std::size_t{32} << 20;  // of stages, and of texts

    Remembered<KeptStage> stages{kMostBytes};
    Remembered<languages::KeptText> texts{kMostBytes};
};

}  // namespace patina::link
