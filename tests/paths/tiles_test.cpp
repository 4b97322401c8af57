// A picture that is drawn in tiles is the picture that is drawn at once: along every path, on the GPU and on the CPU.
//
// The CPU's pictures are equal to the last bit. On a GPU, the viewport moves with the tile: vertices are rounded to
// 1/256 of a sample after that, and interpolated values count from the corner of the tile. So a sample at an edge may
// go to the other side, and other values differ in their last bits, which steep functions of them increase.
#include "paths/drawing/drawing.h"
#include "runtime/picture/compare.h"
#include "runtime/render/render_request.h"

namespace patina::paths {
namespace {

using runtime::compare;
using runtime::Comparison;
using runtime::RenderMachine;
using runtime::RenderOutcome;
using runtime::RenderRequest;

RenderMachine& machine() {
    static RenderMachine machine;
    return machine;
}

RenderOutcome rendered(const RenderRequest& request) {
    RenderOutcome outcome = runtime::render(compiler(), request, machine());
    EXPECT_TRUE(outcome.ok) << request.graph << ": " << outcome.error;
    return outcome;
}

// The side of a tile is 16 to 40 samples then, by the number of targets.
constexpr std::size_t kSmall = 60'000;
constexpr double kHalfStep = 0.5 / 255;

RenderRequest request_of(const std::string& graph, const std::string& path, const std::string& via) {
    return {.graph = graph,
            .size = 61,
            .height = 47,
            .samples = 2,
            .options = {.path = path, .via = via, .validation = via != "cpu", .shadow_atlas_size = 256}};
}

std::string scene(const std::string& name) {
    return "examples/scenes/" + name + ".scene.json";
}

// The picture in tiles is the one that is drawn at once. `most`: the share of pixels that may differ by half a step of
// a picture of bytes.
void expect_same(RenderRequest request, double most = 0) {
    const RenderOutcome whole = rendered(request);
    request.options.most_target_bytes = kSmall;
    const RenderOutcome tiles = rendered(request);
    const std::string what = request.graph + ", " + request.options.path + ", " + request.options.via;
    EXPECT_EQ(whole.tiles, 1u) << what;
    EXPECT_GT(tiles.tiles, 5u) << what;
    const bool is_exact = request.options.via == "cpu";
    const Comparison apart = compare(whole.image, tiles.image, is_exact ? 0 : kHalfStep);
    EXPECT_TRUE(apart.same_size) << what;
    EXPECT_LE(apart.share, is_exact ? 0 : most) << what << ", at " << apart.worst_x << ", " << apart.worst_y;
    EXPECT_LT(apart.average, is_exact ? 1e-30 : 2e-5) << what;
}

// Shadow maps, light volumes and lighting groups are among the steps.
TEST(Tiles, AreTheWholePictureAlongEveryPath) {
    for (const char* path : {"forward", "forward-add", "forward-directional", "vertex", "deferred", "deferred-ldr",
                             "deferred-extended", "deferred-shadowmask"})
        expect_same(request_of(scene("five-lights"), path, "glsl"));
}

TEST(Tiles, AreTheWholePictureInHlsl) {
    for (const char* path : {"forward", "deferred-extended"})
        expect_same(request_of(scene("five-lights"), path, "hlsl"));
}

TEST(Tiles, AreTheWholePictureOnTheCpu) {
    for (const char* path : {"forward-add", "deferred", "deferred-ldr"}) {
        RenderRequest request = request_of(scene("five-lights"), path, "cpu");
        request.size = 41;
        request.height = 31;
        expect_same(request);
    }
}

// Cutout, blended and instanced objects, and water that reads the picture and the depth behind its own pixel.
TEST(Tiles, HoldEveryKindOfSurface) {
    expect_same(request_of(scene("surfaces"), "forward", "glsl"));
    expect_same(request_of(scene("beads"), "deferred", "glsl"));
    expect_same(request_of(scene("shore"), "forward", "glsl"), 0.001);
    RenderRequest shore = request_of(scene("shore"), "deferred", "cpu");
    shore.size = 41;
    shore.height = 31;
    expect_same(shore);
}

// The place in the picture, derivatives, and mip levels, which groups of 2 x 2 samples choose.
TEST(Tiles, HoldPlacesAndDerivativesOfTheWholePicture) {
    const std::string graph = written("places.graph.json", R"json({
  "patina": 1, "workflow": "unlit",
  "properties": [ { "name": "_Map", "type": "texture2d", "default": "./noise.exr" } ],
  "nodes": [
    { "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map", "uv": "= @uv0 * 3.3" } },
    { "id": "pixel", "expr": "frac(floor(@fragCoord.xy) * 0.37) * 0.2" },
    { "id": "slope", "expr": "float2(ddx(@uv0.x), ddy(frac(@fragCoord.x * 0.37 + @fragCoord.y * 0.11)))" }
  ],
  "surface": { "color": "= float3(@screenUV * 0.5 + pixel, texel.r) + float3(slope, 0)" }
})json");
    written_texture("noise.exr", 64, 64, [](int x, int y) { return glm::dvec4((x * 7 + y * 13) % 32 / 32.0); });
    for (const char* via : {"glsl", "hlsl", "cpu"}) expect_same(request_of(graph, "forward", via));
}

// A viewport that is as large as the picture is too large for the device: clip space is cut instead.
TEST(Tiles, CutClipSpaceWhereTheViewportIsTooLarge) {
    for (const char* path : {"forward", "deferred"}) {
        RenderRequest request = request_of(scene("five-lights"), path, "glsl");
        request.options.largest_viewport = 64;
        expect_same(request, 0.01);
    }
}

TEST(Tiles, HoldPreviews) {
    RenderRequest request = request_of("examples/graphs/rusted_steel.graph.json", "forward", "glsl");
    request.options.preview = "masks";
    request.range = runtime::DataRange{.low = -1, .high = 1};
    expect_same(request);
}

// Glass that bends its view reads the picture at other places. It is drawn at once, if that is not too much.
TEST(Tiles, AreRefusedWhereAPassReadsOtherPixels) {
    RenderRequest request = request_of(scene("glass"), "forward", "glsl");
    request.options.most_target_bytes = kSmall;
    EXPECT_EQ(rendered(request).tiles, 1u);
    request.options.most_whole_bytes = 200'000;
    const RenderOutcome outcome = runtime::render(compiler(), request, machine());
    EXPECT_FALSE(outcome.ok);
    EXPECT_EQ(
        outcome.error,
        "the pass 'forward' of 'Rippled glass' reads the picture at other pixels than its own, so the picture "
        "cannot be drawn in tiles; 61 x 47 pixels of 2 x 2 samples at once need 0.0 GiB of render targets, and "
        "the limit is 0.0 GiB and 16384 samples on a side: use --samples 1 and a smaller picture, of 30 x 23 pixels");
    request.options.most_whole_bytes = 300'000;
    EXPECT_TRUE(runtime::render(compiler(), request, machine()).error.ends_with("on a side: use --samples 1"));
}

// Wider than an image can be, and low.
TEST(Tiles, HoldPicturesThatAreWiderThanAnImage) {
    RenderRequest request = request_of("examples/graphs/checker.graph.json", "forward", "glsl");
    request.mesh = "plane";
    request.size = 8192;
    request.height = 2;
    request.samples = 4;
    const RenderOutcome wide = rendered(request);
    EXPECT_EQ(wide.tiles, 8u);
    EXPECT_EQ(wide.image.width, 8192);
}

// What a pass may read in a tile is the place of its own pixel, however it got there.
TEST(Tiles, APassSaysWhetherItReadsOtherPixels) {
    const auto reads_elsewhere = [](const std::string& name, const std::string& color) {
        const std::string graph = written(name + ".graph.json", R"({ "patina": 1, "workflow": "unlit",
  "nodes": [ { "id": "behind", "node": "SceneColor", "in": { "uv": "= @screenUV" } },
             { "id": "bent", "node": "SceneColor", "in": { "uv": "= @screenUV + 0.1" } } ],
  "surface": { "color": ")" + color + "\" } }");
        const Result made = compiled(graph, "forward");
        const Pass* pass = find_pass(made, "forward");
        EXPECT_TRUE(pass) << name;
        return pass && pass->reads_elsewhere;
    };
    EXPECT_FALSE(reads_elsewhere("none", "= float3(@screenUV, 0)"));
    EXPECT_FALSE(reads_elsewhere("own", "= @sceneColor * @sceneDepth"));
    EXPECT_FALSE(reads_elsewhere("node", "behind"));
    EXPECT_TRUE(reads_elsewhere("bent", "bent"));
    for (const char* path : {"deferred", "deferred-ldr", "deferred-extended", "deferred-shadowmask"}) {
        const Result made = compiled("examples/graphs/rusted_steel.graph.json", path);
        for (const Pass& pass : made.reflection.passes) EXPECT_FALSE(pass.reads_elsewhere) << pass.name;
    }
}

}  // namespace
}  // namespace patina::paths
