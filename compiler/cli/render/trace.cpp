// patina trace: every node's value at one pixel of the picture of a graph or scene, computed by the CPU interpreter.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/render/picture_options.h"
#include "compiler/json/json_writer.h"
#include "runtime/picture/image.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string pixel;
    std::vector<std::string> set;
    PathOptions path;  // -D alone
    std::string node;
    bool in_double = false;
    bool places = false;
    bool json = false;
    int x = 0, y = 0;
    runtime::RenderRequest request;
};

int height_of(const runtime::RenderRequest& request) {
    return request.height ? request.height : request.size;
}

// A row of the table. corner: of the triangle, if the value was computed in the vertex stage; else -1.
struct Row {
    const TracedValue* value = nullptr;
    int corner = -1;
};

// --- which rows

// "rust" is the node and the nodes inside it; "rust.amount" is one port.
bool is_wanted(const TracedValue& value, const std::string& wanted) {
    return wanted.empty() || value.node == wanted || value.node.starts_with(wanted + "/") ||
           value.node + "." + value.port == wanted;
}

std::vector<Row> rows_of(const runtime::PixelTrace& trace, const std::string& wanted) {
    std::vector<Row> rows;
    for (int corner = 0; corner < 3; ++corner) {
        for (const TracedValue& value : trace.corners[static_cast<std::size_t>(corner)]) {
            if (is_wanted(value, wanted)) rows.push_back({&value, corner});
        }
    }
    for (const TracedValue& value : trace.values) {
        if (is_wanted(value, wanted)) rows.push_back({&value, -1});
    }
    return rows;
}

// Objects of a scene that the pixel shows in addition to the traced one, from front to back: "'wall', 'floor'".
std::string others_text(const runtime::TraceOutcome& outcome) {
    std::string text;
    for (const std::string& name : outcome.seen)
        if (name != outcome.object) text += (text.empty() ? "'" : ", '") + name + "'";
    return text;
}

Exit no_such_node(const Console& console, const runtime::TraceOutcome& outcome, const std::string& wanted) {
    std::vector<std::string> known;
    for (const Row& row : rows_of(outcome.trace, {})) {
        if (std::find(known.begin(), known.end(), row.value->node) == known.end()) known.push_back(row.value->node);
    }
    const std::string advice = suggestion(wanted, known), others = others_text(outcome);
    std::string rest = outcome.object.empty() ? "" : fmt::format(" for the object '{}'", outcome.object);
    if (!advice.empty()) rest += "; " + advice;
    if (!others.empty()) rest += fmt::format("; the pixel shows {} too, which --object traces", others);
    complain(console, Complaint::NodeNotComputed, {wanted, rest});
    return Exit::Wrong;
}

// --- as text

// "material", "lighting, light 0"
std::string section_of(const Row& row) {
    std::string section = row.value->graph;
    if (row.corner >= 0) section += fmt::format(", vertex stage, corner {} of the triangle", row.corner);
    if (row.value->light >= 0) section += fmt::format(", light {}", row.value->light);
    return section;
}

std::string text_of(const TracedValue& value) {
    std::string text;
    for (double number : value.values) {
        if (!text.empty()) text += ", ";
        if (std::isnan(number)) number = std::abs(number);  // its sign says nothing
        text += value.type.starts_with("bool") ? (number != 0 ? "true" : "false") : fmt::format("{:.6g}", number);
    }
    return text;
}

std::string place_of(const TracedValue& value) {
    return value.line == 0 ? value.file : fmt::format("{}:{}:{}", value.file, value.line, value.column);
}

void print_table(const Console& console, const std::vector<Row>& rows, bool places) {
    std::size_t node = 4, port = 4, type = 4, number = 5;
    for (const Row& row : rows) {
        node = std::max(node, row.value->node.size());
        port = std::max(port, row.value->port.size());
        type = std::max(type, row.value->type.size());
        number = std::max(number, text_of(*row.value).size());
    }
    const auto line = [&](std::string_view a, std::string_view b, std::string_view c, std::string_view d,
                          std::string_view e) {
        std::string text = fmt::format("  {:<{}}  {:<{}}  {:<{}}  {}", a, node, b, port, c, type, d);
        if (places) text = fmt::format("{:<{}}  {}", text, 8 + node + port + type + number, e);
        print(text.substr(0, text.find_last_not_of(' ') + 1) + "\n");
    };
    line("NODE", "PORT", "TYPE", "VALUE", "PLACE");
    std::string section;
    for (const Row& row : rows) {
        const TracedValue& value = *row.value;
        if (const std::string own = section_of(row); own != section) {
            print("\n" + heading(console, own) + "\n");
            section = own;
        }
        line(value.node, value.port, value.type, text_of(value), place_of(value));
    }
}

std::string color_text(const std::array<float, 4>& color) {
    return fmt::format("{:.6g}, {:.6g}, {:.6g}, {:.6g}", color[0], color[1], color[2], color[3]);
}

// As a PNG stores the colour.
std::string as_hex(const std::array<float, 4>& color) {
    runtime::Image pixel = runtime::make_image(1, 1, color[0], color[1], color[2], color[3]);
    runtime::encode_srgb(pixel);
    pixel = runtime::quantized(pixel);
    std::string hex = "#";
    for (int c = 0; c < 3; ++c) hex += fmt::format("{:02x}", static_cast<int>(255 * pixel.pixels[c] + 0.5f));
    return hex;
}

// "object 'wall', instance 2 of 0 to 9, material 'brick' (brick.graph.json)"
std::string object_text(const runtime::TraceOutcome& outcome) {
    std::string text = fmt::format("object '{}'", outcome.object);
    if (outcome.instances > 0)
        text += fmt::format(", instance {} of 0 to {}", outcome.trace.instance, outcome.instances - 1);
    return text + fmt::format(", material '{}' ({})", outcome.material, outcome.graph);
}

// Only a scene has objects to name.
void print_object(const Arguments& arguments, const runtime::TraceOutcome& outcome) {
    if (!is_scene(arguments.request.graph)) return;
    print(object_text(outcome) + "\n");
    if (outcome.trace.is_hidden)
        print(fmt::format("it is hidden here by '{}'; the values are those that it would have\n",
                          outcome.seen.empty() ? "another object" : outcome.seen.front()));
    else if (const std::string others = others_text(outcome); !others.empty())
        print(fmt::format("the pixel shows {} too, which --object traces\n", others));
}

// Why no node has a value.
std::string uncovered_text(const Arguments& arguments) {
    const bool is_of_scene = is_scene(arguments.request.graph);
    const std::string& object = arguments.request.object;
    const std::string what = !is_of_scene     ? "the mesh does"
                             : object.empty() ? "the objects of the scene do"
                                              : "the object '" + object + "' does";
    return what + " not cover this pixel: nothing was computed\n";
}

void print_text(const Console& console, const Arguments& arguments, const runtime::TraceOutcome& outcome,
                const std::vector<Row>& rows) {
    const int samples = arguments.request.samples;
    std::string title = fmt::format("{}, pixel {},{} of {} x {}", arguments.request.graph, arguments.x, arguments.y,
                                    arguments.request.size, height_of(arguments.request));
    const runtime::PixelTrace& trace = outcome.trace;
    if (trace.is_covered && samples > 1) {
        title += fmt::format(", sample {},{} of {} x {}", trace.sample_x, trace.sample_y, samples, samples);
    }
    print(heading(console, title) + "\n");
    if (!trace.is_covered) {
        print(uncovered_text(arguments));
    } else {
        print_object(arguments, outcome);
        if (trace.is_extra) print(fmt::format("pass '{}', which the material adds\n", trace.pass));
        if (trace.is_discarded)
            print("every fragment of this pixel was discarded; the values are those of the nearest fragment\n");
        print("\n");
        print_table(console, rows, arguments.places);
        if (samples > 1) print("\nsample  " + color_text(trace.sample_color));
    }
    print("\npixel   " + color_text(trace.color) + "  " + as_hex(trace.color) + " in sRGB\n");
}

// --- as JSON

void write_row(JsonWriter& json, const Row& row) {
    const TracedValue& value = *row.value;
    json.begin('{');
    json.write("graph", value.graph);
    json.write("kind", value.kind);
    json.write("node", value.node);
    json.write("port", value.port);
    json.write("type", value.type);
    json.write_numbers("value", value.values);
    if (row.corner >= 0) json.write("corner", row.corner);
    if (value.light >= 0) json.write("light", value.light);
    json.if_any("file", value.file);
    if (value.line > 0) {
        json.write("line", value.line);
        json.write("column", value.column);
    }
    json.end();
}

std::string as_json(const Arguments& arguments, const runtime::TraceOutcome& outcome, const std::vector<Row>& rows) {
    const runtime::PixelTrace& trace = outcome.trace;
    JsonWriter json;
    json.begin('{');
    json.write("graph", arguments.request.graph);
    json.write("pass", outcome.pass);
    json.write("precision", arguments.in_double ? "double" : "float");
    json.write("size", arguments.request.size);
    json.write("height", height_of(arguments.request));
    json.write("samples", arguments.request.samples);
    json.write("pixel", std::array{arguments.x, arguments.y});
    json.write("covered", trace.is_covered);
    if (is_scene(arguments.request.graph)) {
        if (trace.is_covered) {
            json.write("object", outcome.object);
            json.write("material", outcome.material);
            json.write("materialGraph", outcome.graph);
            if (outcome.instances > 0) json.write("instance", trace.instance);
            json.write("hidden", trace.is_hidden);
        }
        json.write("seen", outcome.seen);
    }
    if (trace.is_covered) {
        json.write("discarded", trace.is_discarded);
        json.write("sample", std::array{trace.sample_x, trace.sample_y});
    }
    json.begin("values", '[');
    for (const Row& row : rows) write_row(json, row);
    json.end();
    if (trace.is_covered) json.write("sampleColor", trace.sample_color);
    json.write("color", trace.color);
    json.end();
    return json.take() + "\n";
}

Exit trace_pixel(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    const Precision precision = arguments.in_double ? Precision::Double : Precision::Float;
    const runtime::TraceOutcome outcome =
        runtime::trace(compiler, arguments.request, arguments.x, arguments.y, precision);
    report(console, outcome.diagnostics);
    if (!outcome.error.empty()) complain(console, Complaint::CannotRender, {outcome.error});
    if (!outcome.ok) return Exit::Wrong;
    const std::vector<Row> rows = rows_of(outcome.trace, arguments.node);
    if (outcome.trace.is_covered && rows.empty() && !arguments.node.empty()) {
        return no_such_node(console, outcome, arguments.node);
    }
    if (arguments.json) {
        print(as_json(arguments, outcome, rows));
    } else {
        print_text(console, arguments, outcome, rows);
    }
    return Exit::Ok;
}

// --- the command line

// "120,80": two whole numbers.
bool read_pixel(std::string_view text, int& x, int& y) {
    const char* end = text.data() + text.size();
    const auto [comma, first] = std::from_chars(text.data(), end, x);
    if (first != std::errc() || comma == end || *comma != ',') return false;
    const auto [rest, second] = std::from_chars(comma + 1, end, y);
    return second == std::errc() && rest == end;
}

void complete(Arguments& arguments, bool has_mesh) {
    refuse_mesh({arguments.request.graph}, has_mesh);
    refuse_object(arguments.request.graph, "--object", arguments.request.object);
    take_overrides(arguments.set, arguments.path, arguments.request);
    if (!read_pixel(arguments.pixel, arguments.x, arguments.y)) {
        throw CLI::ValidationError("--pixel", "'" + arguments.pixel + "' is not of the form X,Y");
    }
    const int width = arguments.request.size, height = height_of(arguments.request);
    if (arguments.x < 0 || arguments.y < 0 || arguments.x >= width || arguments.y >= height) {
        throw CLI::ValidationError(
            "--pixel",
            fmt::format("{},{} is outside the picture, whose pixels are 0,0 to {},{}: --size makes it larger",
                        arguments.x, arguments.y, width - 1, height - 1));
    }
}

}  // namespace

void add_trace(Program& program) {
    CLI::App& command = add_command(
        program, "trace",
        {"patina trace rust.graph.json --pixel 256,200", "patina trace rust.graph.json --pixel 256,200 --node rust",
         "patina trace rust.graph.json --pixel 256,200 -D _Mode=Wet",
         "patina trace rust.graph.json --pixel 20,30 --size 64 --mesh torus --set _Roughness=0.2 --places",
         "patina trace rust.graph.json --pixel 256,200 --light 'point position=1,2,0' --double --json",
         "patina trace room.scene.json --pixel 256,200", "patina trace room.scene.json --pixel 256,200 --object wall"});
    add_pixels_option(program, command);
    auto arguments = std::make_shared<Arguments>();
    command
        .add_option(
            "GRAPH", arguments->request.graph,
            "A material graph or a scene (JSON). A scene has meshes and values of its own: --mesh and --set are "
            "for graphs")
        ->required()
        ->type_name(" ");
    command
        .add_option("--pixel", arguments->pixel,
                    "The pixel, counted from the top left of the picture that 'patina render' makes")
        ->required()
        ->type_name("X,Y");
    command
        .add_option("--node", arguments->node,
                    "Show only this node and the nodes inside it, or one port: rust, rust/height, rust.amount")
        ->type_name("ID")
        ->check(is_not_empty);
    command
        .add_option("--object", arguments->request.object,
                    "Of a scene: trace the object with this id, even if another one hides it; default: the front-most "
                    "one at the pixel")
        ->type_name("ID")
        ->check(is_not_empty);
    command.add_flag("--places", arguments->places, "Show the line and column of each node in its file");
    command.add_flag("--double", arguments->in_double, "Compute in double; default: 32-bit float, as a GPU does");
    command.add_flag("--json", arguments->json, "Print everything as one JSON object, with all digits");
    add_picture_options(command, arguments->set, arguments->request);
    command.add_option("--time", arguments->request.time, "The time in seconds; default: that of the scene, or 0")
        ->type_name("T")
        ->check(is_time_word);
    add_define_option(command, arguments->path.defines);
    set_check(command, [arguments, mesh = command.get_option("--mesh")] { complete(*arguments, mesh->count() > 0); });
    set_work(program, command, [arguments](const Console& console) { return trace_pixel(console, *arguments); });
}

}  // namespace patina::cli
