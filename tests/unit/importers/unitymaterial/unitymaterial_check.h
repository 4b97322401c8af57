// What the tests of Unity's materials share: importing one, and looking at what it became.
#pragma once

#include <cstdlib>

#include "compiler/importers/importer.h"
#include "patina/patina.h"
#include "tests/unit/importers/unitymaterial/unitymaterial_writer.h"

namespace patina::importers {

inline const Compiler& compiler() {
    static const Compiler made;
    return made;
}

inline Imported import_file(const std::string& path) {
    const Source source{.path = path, .start = {}};
    return importer_of(source)->read(source, {});
}
inline Imported import_material(const std::string& text) {
    return import_file(MaterialFolder().save("x.mat", text));
}
inline Imported import(const MaterialText& material) {
    return import_material(material.text());
}
inline Imported import_in(const MaterialFolder& folder, const MaterialText& material) {
    return import_file(folder.save("x.mat", material.text()));
}

inline const std::string& file_of(const Imported& made, const std::string& name) {
    static const std::string kNone;
    for (const TextFile& each : made.graphs)
        if (each.name == name) return each.text;
    ADD_FAILURE() << name << " is not there: " << made.error;
    return kNone;
}
inline const std::string& graph_of(const Imported& made) {
    return file_of(made, "x.graph.json");
}

// All remarks of a kind, "part: text".
inline std::string remarks(const Imported& made, Remark::Kind kind) {
    std::string text;
    for (const Remark& each : made.remarks)
        if (each.kind == kind) text += each.part + ": " + each.text + "\n";
    return text;
}

inline std::size_t count(const std::string& text, const std::string& part) {
    std::size_t made = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++made;
    return made;
}

// The numbers of a list, which begins behind `before`.
inline std::vector<double> numbers_of(const std::string& text, const std::string& before) {
    std::vector<double> made;
    const std::size_t found = text.find(before);
    if (found == text.npos) return made;
    const char* at = text.c_str() + found + before.size();
    while (*at && *at != ']') {
        char* end = nullptr;
        made.push_back(std::strtod(at, &end));
        at = end;
        while (*at == ',' || *at == ' ') ++at;
    }
    return made;
}

// As GLSL, HLSL and Unity's file, without an error.
inline void expect_compiles(const Imported& made, const std::string& what, const std::string& name = "x.graph.json") {
    EXPECT_EQ(made.error, "") << what;
    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const TextFile& file : made.graphs)
            if (file.name == path || "./" + file.name == path) return file.text;
        return std::nullopt;
    };
    options.files.exists = [](const std::string&) { return true; };  // pictures
    options.targets = compiler().targets("glsl");
    for (const char* word : {"hlsl", "unity"})
        for (const auto& each : compiler().targets(word)) options.targets.push_back(each);
    const std::string& text = file_of(made, name);
    const Result result = compiler().compile_text(name, text, options);
    EXPECT_TRUE(result.ok) << what << "\n" << text;
    for (const Diagnostic& each : result.diagnostics)
        if (each.severity == Severity::Error) ADD_FAILURE() << what << ": " << to_text(each) << "\n" << text;
    // It is as `patina fmt` leaves it.
    EXPECT_EQ(compiler().format(name, text).text, text);
}

}  // namespace patina::importers
