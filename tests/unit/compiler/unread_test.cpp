// What is seen of the library's declarations without parsing them is what the parser finds.
#include "compiler/nodelang/unread.h"

#include <gtest/gtest.h>

#include "compiler/nodelang/embedded.h"

namespace patina::nodelang {
namespace {

template <class Decl>
void expect_same(const StableList<Decl>& whole, std::size_t& next, const Decl& part, std::string_view name) {
    ASSERT_LT(next, whole.size());
    const Decl& same = whole[next++];
    EXPECT_EQ(part.name, name);
    EXPECT_EQ(part.name, same.name);
    EXPECT_EQ(part.doc, same.doc);
    EXPECT_EQ(part.span, same.span) << name;
}

std::size_t count(const Ast& ast) {
    return ast.functions.size() + ast.structs.size() + ast.enums.size() + ast.variables.size();
}

TEST(Unread, DeclarationsAreThoseOfTheWholeFile) {
    int split_files = 0;
    for (const EmbeddedFile& file : embedded_files()) {
        if (!file.path.ends_with(".hlsl")) continue;
        SCOPED_TRACE(std::string(file.path));
        std::deque<Unread> parts;
        if (!split({.text = file.text, .base = 1}, parts)) continue;
        ++split_files;
        Ast whole;
        Diagnostics diagnostics;
        parse_file({.text = file.text, .base = 1}, whole, diagnostics, Bodies::WhenAsked);
        std::size_t all = 0, functions = 0, structs = 0, enums = 0, variables = 0;
        for (const Unread& part : parts) {
            const Ast& ast = part.ast();
            EXPECT_EQ(count(ast), 1u) << part.name();
            all += count(ast);
            for (const FunctionDecl& each : ast.functions) {
                expect_same(whole.functions, functions, each, part.name());
                EXPECT_EQ(each.attributes.size(), whole.functions[functions - 1].attributes.size());
                EXPECT_EQ(each.params.size(), whole.functions[functions - 1].params.size());
                EXPECT_EQ(each.doc_begin, whole.functions[functions - 1].doc_begin);
            }
            for (const StructDecl& each : ast.structs) expect_same(whole.structs, structs, each, part.name());
            for (const EnumDecl& each : ast.enums) {
                expect_same(whole.enums, enums, each, part.name());
                EXPECT_EQ(each.docs, whole.enums[enums - 1].docs);
            }
            for (const VariableDecl& each : ast.variables) expect_same(whole.variables, variables, each, part.name());
        }
        EXPECT_EQ(all, count(whole));
    }
    EXPECT_GT(split_files, 30);  // all nodes; the files of passes and of the stage are read at once
}

TEST(Unread, FilesThatAreWrittenOtherwiseAreReadAtOnce) {
    for (const char* text : {
             "[pass(\"forward\")] [vertex]\nfloat4 v() {\n    return 0;\n}\n",  // somebody asks for all passes
             "float f(float x) {\n    return x;\n",                             // it does not end
             "float f(float x) {\nreturn x;\n}\n",                              // a line at the margin
             "#define X 1\n",
         }) {
        std::deque<Unread> parts;
        EXPECT_FALSE(split({.text = text, .base = 1}, parts)) << text;
        EXPECT_TRUE(parts.empty());
    }
}

TEST(Unread, OneLineIsADeclaration) {
    std::deque<Unread> parts;
    ASSERT_TRUE(
        split({.text = "/// A half.\nconst float HALF = 0.5;  // no more\n[node(\"A/B\")] float F(float x = 1) { "
                       "return x; }\nenum Mode { One, Two };\n",
               .base = 1},
              parts));
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[0].name(), "HALF");
    EXPECT_EQ(parts[0].ast().variables.front().doc, "/// A half.");
    EXPECT_EQ(parts[1].name(), "F");
    EXPECT_EQ(parts[1].ast().functions.front().params.size(), 1u);
    EXPECT_EQ(parts[2].name(), "Mode");
    EXPECT_EQ(parts[2].ast().enums.front().values.size(), 2u);
}

}  // namespace
}  // namespace patina::nodelang
