// Keeps the text of a stage in a language for the next shader that has the same stage (link/known_passes.h). A text
// depends on the stage, the language and the header, and on nothing else; another header replaces the one that it has.
#pragma once

#include "compiler/base/remembered.h"
#include "compiler/languages/print.h"

namespace patina::output {

// A stage by its address: the key keeps it alive, so no other stage can have that address.
struct TextKey {
    std::shared_ptr<const ir::Module> stage{};
    const languages::LanguageInfo* language = nullptr;
    friend bool operator==(const TextKey&, const TextKey&) = default;

    struct Hash {
        std::size_t operator()(const TextKey& key) const {
            return std::hash<const void*>{}(key.stage.get()) * 31 + std::hash<const void*>{}(key.language);
        }
    };
};
using KnownTexts = Remembered<TextKey, languages::Printed, TextKey::Hash>;

}  // namespace patina::output
