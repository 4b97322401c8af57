// The inputs of MaterialX's surface shaders: defaults, layers that are off, units.
#include "compiler/importers/mtlx/graph_maker.h"
#include "tests/unit/importers/mtlx/mtlx_document.h"

namespace patina::importers {
namespace {

// Its inputs are of the graph's interface, if `value` names none of them.
Imported surface(const std::string& shader, const std::string& inputs, const std::string& before = {}) {
    return import_mtlx(
        material(fmt::format(R"(<{0} name="shader" type="surfaceshader">{1}</{0}>)", shader, inputs), before));
}
std::string number(const std::string& name, const std::string& value, const std::string& more = {}) {
    return fmt::format(R"(<input name="{}" type="float" value="{}" {}/>)", name, value, more);
}
// A property of that value.
std::string property(const std::string& name, const std::string& value, const std::string& more = {}) {
    return fmt::format(
        R"(<nodegraph name="NG"><input name="{0}" type="float" value="{1}" {2}/><output name="out" type="float" interfacename="{0}"/></nodegraph>)",
        name, value, more);
}
std::string connected(const std::string& name) {
    return fmt::format(R"(<input name="{}" type="float" nodegraph="NG" output="out"/>)", name);
}

bool has(const Imported& made, const std::string& part) {
    return text_of(made).find(part) != std::string::npos;
}

// Many programs write all inputs.
TEST(MtlxSurface, WrittenDefaultsAreNoInputs) {
    for (const std::string_view shader : mtlx::surface_shaders()) {
        const bool is_specular = shader.ends_with(" specular");
        const std::string category(shader.substr(0, shader.find(' ')));
        const std::string first = is_specular ? R"(<input name="useSpecularWorkflow" type="integer" value="1"/>)" : "";
        std::string inputs = first;
        for (const mtlx::Port& port : mtlx::surface_rule(shader)->rule.inputs)
            if (!port.otherwise.starts_with('@') && !(is_specular && port.name == "useSpecularWorkflow"))
                inputs +=
                    fmt::format(R"(<input name="{}" type="{}" value="{}"/>)", port.name, port.type, port.otherwise);
        for (const mtlx::SurfaceRule::Ignored& each : mtlx::surface_rule(shader)->ignored)
            if (!each.otherwise.starts_with('@') && !mtlx::surface_rule(shader)->rule.input(each.input))
                inputs += fmt::format(R"(<input name="{}" type="{}" value="{}"/>)", each.input,
                                      each.otherwise == "false"                            ? "boolean"
                                      : each.otherwise.find(',') != std::string_view::npos ? "color3"
                                                                                           : "float",
                                      each.otherwise);
        const Imported made = surface(category, inputs);
        EXPECT_EQ(text_of(made), text_of(surface(category, first))) << shader;
        EXPECT_EQ(remarks(made, Remark::Kind::Changed), "") << shader;
        EXPECT_EQ(remarks(made, Remark::Kind::LeftOut), "") << shader;
    }
}

TEST(MtlxSurface, AFilmIsThereWhereItIsThick) {
    Imported made = surface("standard_surface", number("thin_film_thickness", "400"));
    EXPECT_TRUE(has(made, R"("thinFilmWeight": 1)")) << text_of(made);
    EXPECT_TRUE(has(made, R"("thinFilmThickness": 0.4)")) << text_of(made);
    EXPECT_TRUE(has(made, R"("thinFilmIor": 1.5)")) << text_of(made);
    made = surface("standard_surface", number("thin_film_thickness", "0"));
    EXPECT_FALSE(has(made, "thinFilm")) << text_of(made);
    made = surface("standard_surface", connected("thin_film_thickness"), property("film", "0"));
    EXPECT_TRUE(has(made, R"("thinFilmWeight": "= $_Film > 0 ? 1.0 : 0.0")")) << text_of(made);
    expect_compiles(made, "film");
}

TEST(MtlxSurface, DispersionIsThereWhereItIsNotZero) {
    Imported made = surface("standard_surface", number("transmission", "1") + number("transmission_dispersion", "0"));
    EXPECT_FALSE(has(made, "transmissionDispersion")) << text_of(made);
    made = surface("standard_surface", number("transmission", "1") + number("transmission_dispersion", "30"));
    EXPECT_TRUE(has(made, R"("transmissionDispersionScale": 1)")) << text_of(made);
    EXPECT_TRUE(has(made, R"("transmissionDispersionAbbe": 30)")) << text_of(made);
    made = surface("standard_surface", connected("transmission_dispersion"), property("spread", "0"));
    EXPECT_TRUE(has(made, R"("transmissionDispersionScale": "= $_Spread > 0 ? 1.0 : 0.0")")) << text_of(made);
    EXPECT_TRUE(has(made, R"("transmissionDispersionAbbe": "= $_Spread > 0 ? $_Spread : 20.0")")) << text_of(made);
    expect_compiles(made, "dispersion");
}

TEST(MtlxSurface, OpacityOfOneGreyIsExact) {
    const auto said = [](const std::string& opacity, const std::string& before = {}) {
        const Imported made =
            surface("standard_surface", "<input name=\"opacity\" type=\"color3\" " + opacity + "/>", before);
        EXPECT_TRUE(has(made, "\"alpha\": ")) << text_of(made);
        return remarks(made, Remark::Kind::Changed);
    };
    const std::string lost =
        "standard_surface 'shader': the surface, lit by 'openpbr': its opacity is that of red, in all channels\n";
    EXPECT_EQ(said(R"(value="0.5, 0.5, 0.5")"), "");
    EXPECT_EQ(said(R"(value="0.5, 0.5, 0.25")"), lost);
    EXPECT_EQ(said(R"(nodename="source_color3")", sources()), lost);
    EXPECT_EQ(
        said(
            R"(nodename="grey")",
            sources() +
                R"(<convert name="grey" type="color3"><input name="in" type="float" nodename="source_float"/></convert>)"),
        "");
    EXPECT_EQ(said(R"(nodename="source_color3" channels="ggg")", sources()), "");
}

// Lengths and angles, in the units that the shader takes.
TEST(MtlxSurface, UnitsAreThoseOfTheInput) {
    const std::string nanometres = R"(unit="nanometer" unittype="distance")", radians = R"(unit="radian")";
    Imported made =
        surface("open_pbr_surface", number("thin_film_weight", "1") + number("thin_film_thickness", "600", nanometres));
    EXPECT_TRUE(has(made, R"("thinFilmThickness": 0.6)")) << text_of(made);
    made = surface("gltf_pbr", number("iridescence", "1") + number("iridescence_thickness", "400", nanometres) +
                                   number("anisotropy_rotation", "0.5", radians) +
                                   number("thickness", "5", R"(unit="centimeter")"));
    EXPECT_TRUE(has(made, R"("iridescenceThickness": 400)")) << text_of(made);
    EXPECT_TRUE(has(made, "float2(cos(0.5), sin(0.5))")) << text_of(made);
    EXPECT_TRUE(has(made, R"("thickness": 0.05)")) << text_of(made);
    made = surface("standard_surface", number("thin_film_thickness", "400", nanometres));
    EXPECT_TRUE(has(made, R"("thinFilmThickness": 0.4)")) << text_of(made);
    made = surface("standard_surface", number("thin_film_thickness", "0.4", R"(unit="micron")"));
    EXPECT_TRUE(has(made, R"("thinFilmThickness": 0.4)")) << text_of(made);
    // Without a unit, the shader's own.
    made = surface("gltf_pbr", number("iridescence", "1") + number("iridescence_thickness", "400") +
                                   number("anisotropy_rotation", "0.5"));
    EXPECT_TRUE(has(made, R"("iridescenceThickness": 400)")) << text_of(made);
    EXPECT_TRUE(has(made, "float2(cos(0.5), sin(0.5))")) << text_of(made);
    // A property is in metres.
    made = surface("gltf_pbr", number("iridescence", "1") + connected("iridescence_thickness"),
                   property("film", "400", nanometres));
    EXPECT_TRUE(has(made, R"("name": "_Film", "type": "float", "default": 4e-7)")) << text_of(made);
    EXPECT_TRUE(has(made, R"("iridescenceThickness": "= $_Film * 1e+09")")) << text_of(made);
    expect_compiles(made, "a property with a unit");
}

TEST(MtlxSurface, UnknownUnitsAreSaid) {
    const Imported made = surface("gltf_pbr", number("thickness", "5", R"(unit="furlong" unittype="distance")"));
    EXPECT_TRUE(has(made, R"("thickness": 5)")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed),
              "input 'thickness': the unit 'furlong' is not known: its number is taken as it is\n");
    EXPECT_EQ(remarks(surface("gltf_pbr", number("thickness", "5", R"(unit="meter")")), Remark::Kind::Changed), "");
}

}  // namespace
}  // namespace patina::importers
