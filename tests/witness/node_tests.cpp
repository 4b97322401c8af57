#include "witness/node_tests.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace patina::witness {

std::string argument_text(const NodeTest::Argument& argument, std::size_t index) {
    if (!argument.enumerator.empty()) return argument.enumerator;
    const std::string texel = "a" + std::to_string(index);
    if (argument.type == "bool") return "(" + texel + ".x > 0.5)";
    // A const parameter, such as a number of octaves, is not read at run time.
    if (argument.type == "int") return literal(argument.values[0]);
    return texel + "." + std::string("xyzw").substr(0, argument.values.size());
}

namespace {

std::string call_text(const NodeTest& test) {
    std::string text = test.node + "(";
    for (std::size_t i = 0; i < test.arguments.size(); ++i)
        text += (i ? ", " : "") + argument_text(test.arguments[i], i);
    return text + ")" + (test.output == "out" ? "" : "." + test.output);
}

}  // namespace

std::vector<Batch> batches_of(const std::vector<NodeTest>& tests) {
    std::vector<Batch> batches;
    for (const NodeTest& test : tests) {
        const std::string call = call_text(test);
        const auto same = [&](const Batch& batch) { return batch.expression == call; };
        auto found = std::find_if(batches.begin(), batches.end(), same);
        if (found == batches.end()) found = batches.insert(batches.end(), {.expression = call, .tests = {}});
        found->tests.push_back(test);
    }
    return batches;
}

std::string graph_of(const Batch& batch, std::size_t components, bool is_bool, const std::string& node) {
    std::string nodes;
    for (std::size_t i = 0; i < batch.tests[0].arguments.size(); ++i)
        nodes += load_node("a" + std::to_string(i), "@fragCoord.x", std::to_string(i)) + ",\n";
    nodes += R"({ "id": "value", )" + (node.empty() ? R"("expr": ")" + batch.expression + "\"" : node) + " }";
    const std::string_view kColors[] = {"float3(value, 0, 0)", "float3(value, 0)", "value", "value.xyz"};
    const std::string color = is_bool ? "float3(value ? 1 : 0, 0, 0)" : std::string(kColors[components - 1]);
    return R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + data_property() + " ],\n\"nodes\": [\n" + nodes +
           " ],\n\"surface\": { \"color\": \"= " + color + "\", \"alpha\": \"= " + (components == 4 ? "value.w" : "1") +
           "\" } }";
}

Image arguments_of(const Batch& batch) {
    const std::size_t rows = std::max<std::size_t>(1, batch.tests[0].arguments.size());
    Image texels = runtime::make_image(static_cast<int>(batch.tests.size()), static_cast<int>(rows));
    for (std::size_t x = 0; x < batch.tests.size(); ++x) {
        for (std::size_t y = 0; y < batch.tests[x].arguments.size(); ++y) {
            const std::vector<double>& values = batch.tests[x].arguments[y].values;
            for (std::size_t c = 0; c < values.size(); ++c)
                texels.at(static_cast<int>(x), static_cast<int>(y))[c] = static_cast<float>(values[c]);
        }
    }
    return texels;
}

namespace {

std::string numbers(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ", ") + testing::PrintToString(value);
    return text;
}

}  // namespace

void expect_passed(const NodeTest& test, const char* witness) {
    EXPECT_TRUE(passed(test)) << test.file << ":" << test.line << ": " << test.text << "\n  " << witness << " says "
                              << numbers(test.actual) << ", expected " << numbers(test.expected) << " within "
                              << test.relative << " relative, " << test.absolute << " absolute";
}

std::size_t expect_passed_when_drawn(Bench& bench, const Material& material, const Batch& batch) {
    std::size_t count = 0;
    const Image arguments = arguments_of(batch);
    const Inputs inputs{.width = arguments.width, .data = texture_of(arguments)};
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        const Image image = bench.draw(material, target, inputs);
        if (image.pixels.empty()) continue;
        for (int x = 0; x < image.width; ++x) {
            NodeTest test = batch.tests[static_cast<std::size_t>(x)];
            for (std::size_t c = 0; c < test.actual.size(); ++c)
                test.actual[c] = static_cast<double>(image.at(x, 0)[c]);
            expect_passed(test, target == Target::Glsl ? "GLSL" : "HLSL");
            ++count;
        }
    }
    return count;
}

}  // namespace patina::witness
