// The parser: every construct of docs/node-language.md, exact positions, and errors that are found at the right place,
// several in one run, without ever recursing far.
#include "tests/unit/compiler/parsed.h"

using namespace patina;
using namespace patina::nodelang;

TEST(ParseExpression, Precedence) {
    EXPECT_EQ(expression("1 + 2 * 3"), "(+ 1 (* 2 3))");
    EXPECT_EQ(expression("a - b - c"), "(- (- a b) c)");
    EXPECT_EQ(expression("a / b * c % d"), "(% (* (/ a b) c) d)");
    EXPECT_EQ(expression("a || b && c | d ^ e & f == g < h << i + j * k"),
              "(|| a (&& b (| c (^ d (& e (== f (< g (<< h (+ i (* j k))))))))))");
    EXPECT_EQ(expression("a ? b : c ? d : e"), "(? a b (? c d e))");
    EXPECT_EQ(expression("a || b ? c + 1 : d"), "(? (|| a b) (+ c 1) d)");
    EXPECT_EQ(expression("-a.x * !b"), "(* (- (.x a)) (! b))");
    EXPECT_EQ(expression("- -a"), "(- (- a))");
    EXPECT_EQ(expression("(1 + 2) * ~3"), "(* (+ 1 2) (~ 3))");
    EXPECT_EQ(expression("a <= b != c >= d"), "(!= (<= a b) (>= c d))");
}

TEST(ParseExpression, CallsMembersAndIndices) {
    EXPECT_EQ(expression("lerp(a.rgb, float3(0), k[i + 1].x)"), "(lerp() (.rgb a) (float3() 0) (.x ([] k (+ i 1))))");
    EXPECT_EQ(expression("texture.Sample(uv * texture.tiling.xy)"),
              "(.Sample() texture (* uv (.xy (.tiling texture))))");
    EXPECT_EQ(expression("f()"), "(f())");
    EXPECT_EQ(expression("SinCos(0.5).cosine"), "(.cosine (SinCos() 0.5))");
}

TEST(ParseExpression, GraphNames) {
    EXPECT_EQ(expression("$_Tint.rgb * @light.direction"), "(* (.rgb $_Tint) (.direction @light))");
    // A node may have any name, and a port be called `out`.
    EXPECT_EQ(expression("if.out + out"), "(+ (.out if) out)");
}

TEST(ParseExpression, SpacesAndComments) {
    EXPECT_EQ(expression("\n\t a\xc2\xa0+\r\n b // and so on"), "(+ a b)");
    EXPECT_EQ(expression("a /* less */ - b"), "(- a b)");
}

TEST(ParseExpression, Numbers) {
    const auto number = [](std::string text) {
        const auto parsed = parse(As::Expression, std::move(text));
        EXPECT_EQ(parsed->errors(), Errors{});
        return std::pair(parsed->expr->number, parsed->expr->number_kind);
    };
    EXPECT_EQ(number("1"), std::pair(1.0, NumberKind::Int));
    EXPECT_EQ(number("1u"), std::pair(1.0, NumberKind::Uint));
    EXPECT_EQ(number("0x1F"), std::pair(31.0, NumberKind::Int));
    EXPECT_EQ(number("0x7fffffff"), std::pair(2147483647.0, NumberKind::Int));
    EXPECT_EQ(number("0xffffffff"), std::pair(4294967295.0, NumberKind::Uint));
    EXPECT_EQ(number("0x10u"), std::pair(16.0, NumberKind::Uint));
    EXPECT_EQ(number("1.0"), std::pair(1.0, NumberKind::Float));
    EXPECT_EQ(number(".5"), std::pair(0.5, NumberKind::Float));
    EXPECT_EQ(number("1."), std::pair(1.0, NumberKind::Float));
    EXPECT_EQ(number("1e-5"), std::pair(1e-5, NumberKind::Float));
    EXPECT_EQ(number("2.5E+2"), std::pair(250.0, NumberKind::Float));
    EXPECT_EQ(number("1.0f"), std::pair(1.0, NumberKind::Float));
    EXPECT_EQ(number("1.0h"), std::pair(1.0, NumberKind::Half));
    EXPECT_EQ(number("true"), std::pair(1.0, NumberKind::Int));
    EXPECT_EQ(number("3.14159265358979"), std::pair(3.14159265358979, NumberKind::Float));
}

TEST(ParseExpression, BadNumbers) {
    for (const char* text : {"0x1ffffffff", "4294967296u", "1.5u", "1abc", "0x", "1.0q", "010", "1e", "1.x"}) {
        const auto parsed = parse(As::Expression, text);
        EXPECT_EQ(parsed->expr, nullptr) << text;
        EXPECT_EQ(parsed->errors(), Errors{fmt::format("[{0}] '{0}' is not a number", text)});
    }
    EXPECT_EQ(parse(As::Expression, "1e999")->errors(),
              Errors{"[1e999] the number 1e999 does not fit in a 32-bit float"});
}

TEST(ParseExpression, SpansAreExact) {
    const auto parsed = parse(As::Expression, "(a + b) * lerp(c, d.x, 1)");
    ASSERT_NE(parsed->expr, nullptr);
    const Expr& product = *parsed->expr;
    EXPECT_EQ(parsed->text(product.span), "(a + b) * lerp(c, d.x, 1)");
    EXPECT_EQ(parsed->text(product.name_span), "*");
    EXPECT_EQ(parsed->text(product.args[0]->span), "a + b");
    const Expr& lerp = *product.args[1];
    EXPECT_EQ(parsed->text(lerp.span), "lerp(c, d.x, 1)");
    EXPECT_EQ(parsed->text(lerp.name_span), "lerp");
    EXPECT_EQ(parsed->text(lerp.args[1]->span), "d.x");
    EXPECT_EQ(parsed->text(lerp.args[1]->name_span), "x");
}

TEST(ParseExpression, EscapedJsonStringsKeepTheirPlaces) {
    // The source says  "a \u002b bad^"  and the decoded text  a + bad^
    SourceMap sources;
    const std::uint32_t base = sources.add("graph", R"("a \u002b b`")");
    const std::string decoded = "a + b`";
    const std::vector<std::uint32_t> map = {base + 1, base + 2, base + 3, base + 9, base + 10, base + 11, base + 12};
    Ast ast;
    Diagnostics diagnostics;
    EXPECT_EQ(parse_expression({.text = decoded, .base = 0, .map = &map}, ast, diagnostics), nullptr);
    ASSERT_EQ(diagnostics.records().size(), 1u);
    EXPECT_EQ(diagnostics.records()[0].code, Code::BadCharacter);
    EXPECT_EQ(diagnostics.records()[0].span, (Span{base + 11, base + 12}));
    const std::string good = "a + b";
    const Expr* sum = parse_expression({.text = good, .base = 0, .map = &map}, ast, diagnostics);
    ASSERT_NE(sum, nullptr);
    EXPECT_EQ(sources.text(sum->name_span), "\\u002b");
    EXPECT_EQ(sources.text(sum->span), "a \\u002b b");
}

TEST(ParseExpression, Errors) {
    const auto error = [](std::string text) {
        const auto parsed = parse(As::Expression, std::move(text));
        EXPECT_EQ(parsed->expr, nullptr);
        const Errors all = parsed->errors();
        return all.size() == 1 ? all[0] : fmt::format("{} errors", all.size());
    };
    EXPECT_EQ(error(""), "[] expected a value, not the end of the expression");
    EXPECT_EQ(error("a +"), "[] expected a value, not the end of the expression");
    EXPECT_EQ(error("a b"), "[b] expected an operator or the end of the expression, not 'b'");
    EXPECT_EQ(error("a + * b"), "[*] expected a value, not '*'");
    EXPECT_EQ(error("max(a, b"), "[] expected ',' or ')', not the end of the expression");
    EXPECT_EQ(error("max(a,)"), "[)] expected a value, not ')'");
    EXPECT_EQ(error("a ? b"), "[] expected ':', not the end of the expression");
    EXPECT_EQ(error("a.1"), "[.1] expected an operator or the end of the expression, not '.1'");
    EXPECT_EQ(error("a. + 1"), "[+] expected the name of a member, not '+'");
    EXPECT_EQ(error("a = b"), "[=] expected an operator or the end of the expression, not '='");
    EXPECT_EQ(error("a \xc3\x97 b"), "[\xc3\x97] '\xc3\x97' is not allowed here");
    EXPECT_EQ(error("\"text\""), "[\"text\"] expected a value, not a string");
    EXPECT_EQ(error("a /* b"), "[/*] expected '*/' after this, not the end of the text");
    EXPECT_EQ(error("1 + $"), "[$] '$' is not allowed here");
    EXPECT_EQ(error(std::string("a\0b", 3)), fmt::format("[{}] the character 0x00 is not allowed here", '\0'));
}

TEST(ParseExpression, DepthIsLimited) {
    const auto nested = [](int depth) { return std::string(depth, '(') + "1" + std::string(depth, ')'); };
    EXPECT_NE(parse(As::Expression, nested(kMaxNesting - 1))->expr, nullptr);
    for (const std::string& text :
         {nested(kMaxNesting), nested(400'000), std::string(500'000, '['), "a" + std::string(500'000, '['),
          std::string(500'000, '-') + "1", std::string(500'000, '!')}) {
        const auto parsed = parse(As::Expression, text);
        EXPECT_EQ(parsed->expr, nullptr);
        EXPECT_EQ(parsed->diagnostics.error_count(), 1u);
    }
    EXPECT_EQ(parse(As::Expression, nested(kMaxNesting))->diagnostics.records()[0].code, Code::TooDeep);
}

TEST(ParseExpression, ChainsAreLimited) {
    const auto chain = [](const std::string& link, int count) {
        std::string text = "a";
        for (int i = 0; i < count; ++i) text += link;
        return text;
    };
    for (const char* link : {"+a", ".x", "[0]", ".f()"}) {
        EXPECT_NE(parse(As::Expression, chain(link, 1000))->expr, nullptr) << link;
        const auto parsed = parse(As::Expression, chain(link, 1001));
        EXPECT_EQ(parsed->expr, nullptr) << link;
        ASSERT_EQ(parsed->diagnostics.records().size(), 1u);
        EXPECT_EQ(parsed->diagnostics.records()[0].code, Code::TooDeep);
    }
    // Chains inside brackets add up.
    EXPECT_EQ(parse(As::Expression, "(" + chain("+a", 600) + ")" + chain("+a", 600).substr(1))->expr, nullptr);
    // Many arguments are wide, not deep.
    std::string wide = "f(a";
    for (int i = 0; i < 5000; ++i) wide += ", a";
    EXPECT_NE(parse(As::Expression, wide + ")")->expr, nullptr);
}

TEST(ParseExpression, HugeTextIsRefused) {
    const auto parsed = parse(As::Expression, std::string(2u << 20, ' '));
    EXPECT_EQ(parsed->diagnostics.records().at(0).code, Code::TooLarge);
}

TEST(ParseLink, Paths) {
    const auto link = [](std::string text) {
        const auto parsed = parse(As::Link, std::move(text));
        EXPECT_EQ(parsed->errors(), Errors{});
        return show(parsed->expr);
    };
    EXPECT_EQ(link("albedo"), "albedo");
    EXPECT_EQ(link("wave.dx.xz"), "(.xz (.dx wave))");
    EXPECT_EQ(link("$_MainTex.texelSize"), "(.texelSize $_MainTex)");
    EXPECT_EQ(link("@light.direction"), "(.direction @light)");
    EXPECT_EQ(link("out.out"), "(.out out)");
    const auto parsed = parse(As::Link, "wave.dx.xz");
    EXPECT_EQ(parsed->text(parsed->expr->span), "wave.dx.xz");
    EXPECT_EQ(parsed->text(parsed->expr->name_span), "xz");
    EXPECT_EQ(parsed->text(parsed->expr->args[0]->span), "wave.dx");
}

TEST(ParseLink, NothingElse) {
    const auto error = [](std::string text) {
        const auto parsed = parse(As::Link, std::move(text));
        EXPECT_EQ(parsed->expr, nullptr);
        return parsed->errors().at(0);
    };
    EXPECT_EQ(error(""), "[] expected a node, a $property or a @semantic, not the end of the expression");
    EXPECT_EQ(error("a + b"), "[+] expected '.' or the end of the link, not '+'");
    EXPECT_EQ(error("a . b"), "[.] expected '.' or the end of the link, not '.'");
    EXPECT_EQ(error("a.b()"), "[(] expected '.' or the end of the link, not '('");
    EXPECT_EQ(error("a."), "[] expected the name of an output, member or swizzle, not the end of the expression");
    EXPECT_EQ(error("1"), "[1] expected a node, a $property or a @semantic, not '1'");
}

TEST(ParseStatement, EveryKind) {
    EXPECT_EQ(body("float x = 1; float3 y;"), "{ float x = 1; float3 y; }");
    EXPECT_EQ(body("const float k[3] = { 0.25, 0.5, 0.25, };"), "{ const float k[3] = { 0.25 0.5 0.25 }; }");
    EXPECT_EQ(body("x += k[1];  v.xy = v.yx;"), "{ x += ([] k 1); (.xy v) = (.yx v); }");
    EXPECT_EQ(body("if (x > 1) { x = 1; } else if (y) x = 2; else { }"),
              "{ if (> x 1){ x = 1; } else{ if y{ x = 2; } else{ } } }");
    EXPECT_EQ(body("for (int i = 0; i < min(count, 16); i++) { x += i; }"), "{ for i 0 (min() count 16){ x += i; } }");
    EXPECT_EQ(body("for (int i = 1; i < 4; ++i) x = i;"), "{ for i 1 4{ x = i; } }");
    EXPECT_EQ(body("[light] for (int i = 0; i < 4; i += 1) { }"), "{ [light] for i 0 4{ } }");
    EXPECT_EQ(body("discardIf(a < b); { return; } ;"), "{ discard (< a b); { return; } }");
    EXPECT_EQ(body("return a ? b : c;"), "{ return (? a b c); }");
}

TEST(ParseStatement, Spans) {
    const auto parsed =
        parse(As::File, "float f(float x)\n{\n    x += 2 * x;\n    if (x > 1) return x;\n    return 1;\n}\n");
    ASSERT_EQ(parsed->errors(), Errors{});
    const FunctionDecl& f = parsed->ast.functions[0];
    ASSERT_EQ(f.body.size(), 3u);
    EXPECT_EQ(parsed->text(f.name_span), "f");
    EXPECT_EQ(parsed->place(f.body[0]->span), "3:5");
    EXPECT_EQ(parsed->text(f.body[0]->span), "x += 2 * x");
    EXPECT_EQ(parsed->text(f.body[0]->name_span), "+=");
    EXPECT_EQ(parsed->text(f.body[1]->span), "if (x > 1) return x;");
    EXPECT_EQ(parsed->text(f.body[1]->body.at(0)->span), "return x");
    EXPECT_EQ(parsed->text(f.body[2]->span), "return 1");
    EXPECT_TRUE(parsed->text(f.span).starts_with("float f(") && parsed->text(f.span).ends_with("}"));
}

TEST(ParseStatement, Errors) {
    const auto errors = [](std::string statements) {
        return parse(As::File, "void f() {" + statements + "\n}")->errors();
    };
    EXPECT_EQ(errors("while (x) { }"), Errors{"[while] expected a statement, not 'while'"});
    EXPECT_EQ(errors("break;"), Errors{"[break] expected a statement, not 'break'"});
    EXPECT_EQ(errors("else x = 1;"), Errors{"[else] expected a statement, not 'else'"});
    EXPECT_EQ(errors("x++;"), Errors{"[++] expected an assignment, not '++'"});
    EXPECT_EQ(errors("f(x);"), Errors{"[;] expected an assignment, not ';'"});
    EXPECT_EQ(errors("float a, b;"), Errors{"[,] expected ';', not ','"});
    EXPECT_EQ(errors("const float a;"), Errors{"[;] expected '=' and the value of the constant, not ';'"});
    EXPECT_EQ(errors("if (x);"), Errors{"[;] expected a statement or '{', not ';'"});
    EXPECT_EQ(errors("float if = 1;"), Errors{"[if] expected a name for the variable, not 'if'"});
    EXPECT_EQ(errors("x = $_Tint.r;"), Errors{"[$_Tint] '$_Tint' is not allowed here"});
    EXPECT_EQ(errors("x = @uv0;"), Errors{"[@uv0] '@uv0' is not allowed here"});
    EXPECT_EQ(errors("[branch] for (int i = 0; i < 2; i++) { }"),
              Errors{"[branch] the attribute 'branch' is not allowed before a statement"});
}

TEST(ParseStatement, LoopShapes) {
    const auto error = [](std::string header) {
        const Errors all = parse(As::File, "void f() { for (" + header + ") { x = 1; } }")->errors();
        return all.size() == 1 ? all[0] : fmt::format("{} errors", all.size());
    };
    EXPECT_EQ(error("int i = 0; i <= 4; i++"), "[<=] expected '<', not '<='");
    EXPECT_EQ(error("int i = 0; j < 4; i++"), "[j] expected 'i', not 'j'");
    EXPECT_EQ(error("int i = 0; i < 4; i += 2"), "[2] expected 'i++', not '2'");
    EXPECT_EQ(error("int i = 0; i < 4; i--"), "[--] expected 'i++', not '--'");
    EXPECT_EQ(error("float i = 0; i < 4; i++"), "[float] expected 'int', not 'float'");
    EXPECT_EQ(error("int i = 0, j = 0; i < 4; i++"), "[,] expected ';', not ','");
    EXPECT_EQ(error("; ; "), "[;] expected 'int', not ';'");
}

TEST(ParseStatement, AMissingSemicolonIsMissedWhereItBelongs) {
    const auto parsed = parse(As::File, "float f() {\n    float x = 1\n    return x +;\n}\n");
    EXPECT_EQ(parsed->errors(), (Errors{"[] expected ';' here, not 'return'", "[;] expected a value, not ';'"}));
    EXPECT_EQ(parsed->place(parsed->diagnostics.records()[0].span), "2:16");
}

TEST(ParseStatement, SeveralErrorsInOneRun) {
    const auto parsed = parse(As::File,
                              "float f() {\n"
                              "    float a = ;\n"
                              "    if (a > ) { a = 1; }\n"
                              "    for (int i = 0; i > 3; i++) { a = a * / 2; }\n"
                              "    a = (1 + 2;\n"
                              "    return a;\n"
                              "}\n"
                              "float g(float a float b) { return 1; }\n"
                              "struct S { float x }; \n"
                              "float h() { return 1 1; }\n");
    EXPECT_EQ(parsed->errors(), (Errors{
                                    "[;] expected a value, not ';'",
                                    "[)] expected a value, not ')'",
                                    "[>] expected '<', not '>'",
                                    "[/] expected a value, not '/'",
                                    "[;] expected ')', not ';'",
                                    "[float] expected ',' or ')', not 'float'",
                                    "[}] expected ';', not '}'",
                                    "[1] expected ';', not '1'",
                                }));
}

TEST(ParseStatement, BlocksAreLimited) {
    for (const std::string& text :
         {"void f() {" + std::string(300'000, '{'), "void f() {" + std::string(300, '{') + std::string(301, '}')}) {
        const auto parsed = parse(As::File, text);
        ASSERT_FALSE(parsed->diagnostics.records().empty());
        EXPECT_EQ(parsed->diagnostics.records()[0].code, Code::TooDeep);
    }
    std::string chain = "void f() { ";
    for (int i = 0; i < 20'000; ++i) chain += "if (a) { } else ";
    EXPECT_EQ(parse(As::File, chain + "{ } }")->diagnostics.records().at(0).code, Code::TooDeep);
}

TEST(ParseDeclaration, Function) {
    const auto parsed = parse(As::File, R"(
/// GGX (Trowbridge-Reitz) normal distribution.
///
/// formula: D = a^2
[node("Lighting/Distribution/GGX")]
float DistributionGGX(
    [range(0, 1)] float ndoth,        ///< cosine of normal and half vector
    [range(-1, 1)] [unit("m")] float alpha = 0.25,  ///< roughness squared
    const BlendMode mode = Reoriented,
    float3 normal = light.direction ///< a semantic
    , Texture2D k[2],
    out float rest  ///< what is left
) {
    return alpha;
}
[slot] float3 direct(LightingSurface surface, Light light);
)");
    ASSERT_EQ(parsed->errors(), Errors{});
    ASSERT_EQ(parsed->ast.functions.size(), 2u);
    const FunctionDecl& f = parsed->ast.functions[0];
    EXPECT_EQ(f.name, "DistributionGGX");
    EXPECT_EQ(f.result.name, "float");
    EXPECT_EQ(f.doc, "/// GGX (Trowbridge-Reitz) normal distribution.\n///\n/// formula: D = a^2");
    EXPECT_EQ(f.doc_begin, parsed->base + 1);
    ASSERT_NE(f.attribute("node"), nullptr);
    EXPECT_EQ(show(f.attribute("node")->args.at(0)), "\"Lighting/Distribution/GGX\"");
    EXPECT_EQ(parsed->text(f.attribute("node")->span), "node(\"Lighting/Distribution/GGX\")");
    EXPECT_TRUE(f.has_body);
    ASSERT_EQ(f.params.size(), 6u);
    EXPECT_EQ(f.params[0].doc, "cosine of normal and half vector");
    EXPECT_EQ(parsed->text(f.params[0].span), "ndoth");
    EXPECT_EQ(f.params[0].initial, nullptr);
    EXPECT_EQ(f.params[1].doc, "roughness squared");
    EXPECT_EQ(show(f.params[1].initial), "0.25");
    ASSERT_EQ(f.params[1].attributes.size(), 2u);
    EXPECT_EQ(show(f.params[1].attributes[0].args.at(0)), "(- 1)");
    EXPECT_TRUE(f.params[2].is_const);
    EXPECT_EQ(f.params[2].doc, "");
    EXPECT_EQ(show(f.params[3].initial), "(.direction light)");
    EXPECT_EQ(f.params[3].doc, "a semantic");
    EXPECT_EQ(show(f.params[4].type.array_size), "2");
    EXPECT_TRUE(f.params[5].is_out);
    EXPECT_EQ(f.params[5].doc, "what is left");

    const FunctionDecl& slot = parsed->ast.functions[1];
    EXPECT_FALSE(slot.has_body);
    EXPECT_NE(slot.attribute("slot"), nullptr);
    EXPECT_EQ(slot.doc, "");
    EXPECT_EQ(parsed->text(slot.result.span), "float3");
}

TEST(ParseDeclaration, StructEnumAndVariables) {
    const auto parsed = parse(As::File,
                              "\xef\xbb\xbf"
                              R"(
/// A light.
struct Light {
    float3 direction;  ///< unit vector to the light
    float k[4];
};
enum BlendMode {
    Whiteout,    ///< the cheap one
    Reoriented   ///< the good one
};
enum One { A, };
const float PI = 3.14;
const float3 k[2] = { float3(1, 0, 0), { 0, 1, 0 } };
[foreign(0, "POSITION")] float3 positionOS;  ///< of the vertex
[static("surface", "cutout")] bool alphaClip;
[extern("Camera")] float4 lights[16];
)");
    ASSERT_EQ(parsed->errors(), Errors{});
    const StructDecl& light = parsed->ast.structs[0];
    EXPECT_EQ(light.name, "Light");
    EXPECT_EQ(light.doc, "/// A light.");
    ASSERT_EQ(light.members.size(), 2u);
    EXPECT_EQ(light.members[0].doc, "unit vector to the light");
    EXPECT_EQ(light.members[0].type.name, "float3");
    EXPECT_EQ(show(light.members[1].type.array_size), "4");
    const EnumDecl& mode = parsed->ast.enums[0];
    EXPECT_EQ(mode.values, (std::vector<std::string_view>{"Whiteout", "Reoriented"}));
    EXPECT_EQ(mode.docs, (std::vector<std::string_view>{"the cheap one", "the good one"}));
    EXPECT_EQ(parsed->ast.enums[1].values.size(), 1u);
    ASSERT_EQ(parsed->ast.variables.size(), 5u);
    EXPECT_TRUE(parsed->ast.variables[0].is_const);
    EXPECT_EQ(show(parsed->ast.variables[0].value), "3.14");
    EXPECT_EQ(show(parsed->ast.variables[1].value), "{ (float3() 1 0 0) { 0 1 0 } }");
    const VariableDecl& position = parsed->ast.variables[2];
    EXPECT_EQ(show(position.attribute("foreign")->args.at(0)), "0");
    EXPECT_EQ(position.attribute("foreign")->args.at(1)->text, "POSITION");
    EXPECT_EQ(position.doc, "of the vertex");
    EXPECT_NE(parsed->ast.variables[3].attribute("static"), nullptr);
    EXPECT_EQ(show(parsed->ast.variables[4].type.array_size), "16");
}

TEST(ParseDeclaration, OnlyTheNearestCommentDescribes) {
    const auto doc = [](std::string text) {
        const auto parsed = parse(As::File, text + "float f();");
        return std::string(parsed->ast.functions[0].doc);
    };
    EXPECT_EQ(doc("/// one\r\n  /// two\r\n"), "/// one\r\n  /// two");
    EXPECT_EQ(doc("/// of the file\n\n/// of f\n"), "/// of f");
    EXPECT_EQ(doc("/// of the file\n// and more\n/// of f\n"), "/// of f");
    EXPECT_EQ(doc("//////////\n"), "");
    EXPECT_EQ(doc("///< of nothing\n"), "");
    EXPECT_EQ(doc("// plain\n"), "");
    EXPECT_EQ(doc("/// far\n\n"), "/// far");
}

TEST(ParseDeclaration, Errors) {
    const auto errors = [](std::string text) { return parse(As::File, std::move(text))->errors(); };
    EXPECT_EQ(errors("float x = 1;"),
              Errors{"[float] expected 'const' or an attribute before a variable of the file, not 'float'"});
    EXPECT_EQ(errors("#include \"x\"\n"), Errors{"[#] '#' is not allowed here"});
    EXPECT_EQ(errors("}"), Errors{"[}] expected a declaration, not '}'"});
    EXPECT_EQ(errors("float f(inout float x) { }"), Errors{"[inout] expected a type, not 'inout'"});
    EXPECT_EQ(errors("float f(out float x = 1);"), Errors{"[=] expected ',' or ')', not '='"});
    EXPECT_EQ(errors("enum E { };"), Errors{"[}] expected a name for a value of the enum, not '}'"});
    EXPECT_EQ(errors("enum E { A B };"), Errors{"[B] expected ',' or '}', not 'B'"});
    EXPECT_EQ(errors("struct S { 1 };"), Errors{"[1] expected a member or '}', not '1'"});
    EXPECT_EQ(errors("[node(\"x)]\nfloat f();"),
              Errors{"[\"] expected another '\"' after this, not the end of the line"});
    EXPECT_EQ(errors("float f() {\n return 1;"), Errors{"[] expected '}', not the end of the file"});
    EXPECT_EQ(errors("struct S { float x; }\nfloat f();"), Errors{"[] expected ';' here, not 'float'"});
}

TEST(ParseDeclaration, NotUtf8) {
    const auto parsed = parse(As::File, "// \xff\n");
    ASSERT_EQ(parsed->diagnostics.records().size(), 1u);
    EXPECT_EQ(parsed->diagnostics.records()[0].code, Code::NotUtf8);
    EXPECT_EQ(parsed->place(parsed->diagnostics.records()[0].span), "1:4");
}

// Whatever is left of a file after a cut is read to its end, quickly and without a crash.
TEST(ParseDeclaration, EveryPrefixOfAFileIsRead) {
    const std::string text =
        "/// doc\n[node(\"A/B\")] float f([range(0,1)] float a = 1.5e-3, out half b) { float k[2] = {1,{2}};\n"
        "for (int i=0;i<min(a,3);i++){ if(a>k[i]&&true) b.x+=texture.Sample(uv,1u); else {a=-a?1:2;} } return a; }\n"
        "struct S { float3 x; }; enum E { P, Q }; [extern] float4 g[4]; /* end */ const uint z = 0xffu;";
    EXPECT_EQ(parse(As::File, text)->errors(), Errors{});
    for (std::size_t length = 0; length < text.size(); ++length) {
        parse(As::File, text.substr(0, length));
        std::string broken = text;
        broken.erase(length, 1);
        parse(As::File, broken);
    }
}
