#include "runtime/snapshot/snapshot_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

class SnapshotFileTest : public testing::Test {
protected:
    SnapshotFileTest() {
        std::string name = (fs::temp_directory_path() / "patina_snapshot_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~SnapshotFileTest() override { fs::remove_all(folder); }
    ReadSnapshot read(const std::string& text) {
        std::ofstream(folder / "rust.snapshot.json", std::ios::binary) << text;
        return read_snapshot((folder / "rust.snapshot.json").string());
    }

    fs::path folder;
};

TEST_F(SnapshotFileTest, LeavesOutWhatHasDefaults) {
    ReadSnapshot read_file = read(R"({ "patina": 1 })");
    ASSERT_TRUE(read_file.file) << to_text(read_file.error);
    const SnapshotFile& file = *read_file.file;
    EXPECT_EQ(file.request.graph, (folder / "rust.graph.json").string());
    EXPECT_EQ(file.request.size, 128);
    EXPECT_EQ(file.request.samples, 2);
    EXPECT_EQ(file.request.mesh, "sphere");
    EXPECT_TRUE(file.request.lights.empty());
}

TEST_F(SnapshotFileTest, FindsModelsNextToItself) {
    EXPECT_EQ(read(R"({ "patina": 1, "mesh": "chair.glb#Seat" })").file->request.mesh,
              (folder / "chair.glb#Seat").string());
    EXPECT_EQ(read(R"({ "patina": 1, "mesh": "torus" })").file->request.mesh, "torus");
}

TEST_F(SnapshotFileTest, ShowsASceneOfItsNameWhereThereIsNoGraph) {
    std::ofstream(folder / "rust.scene.json") << "{}";
    EXPECT_EQ(read(R"({ "patina": 1 })").file->request.graph, (folder / "rust.scene.json").string());
    std::ofstream(folder / "rust.graph.json") << "{}";
    EXPECT_EQ(read(R"({ "patina": 1 })").file->request.graph, (folder / "rust.graph.json").string());
}

TEST_F(SnapshotFileTest, ThePathIsAWordOrAFileBesideIt) {
    EXPECT_EQ(read(R"({ "patina": 1, "path": "deferred" })").file->request.options.path, "deferred");
    EXPECT_EQ(read(R"({ "patina": 1, "path": "mine.pass.hlsl" })").file->request.options.path,
              (folder / "mine.pass.hlsl").string());
}

TEST_F(SnapshotFileTest, ReadsEverything) {
    std::ofstream(folder / "rust.png") << "x";
    ReadSnapshot read_file = read(R"({
        // a comment, and a trailing comma
        "patina": 1, "graph": "other.graph.json", "mesh": "torus", "size": 64, "samples": 1, "segments": 512, "time": 1.5, "node": "mask", "object": "wall", "material": "brick",
        "camera": { "position": [2, 1, 3], "fov": 40 }, "ambient": 0.2, "via": "cpu", "lights": ["directional", "point range=3"],
        "set": { "_Roughness": 0.25, "_Tint": [1, 0, 0.5], "_On": true, "_Mode": "Wet", "_MainTex": "rust.png" },
        "tolerance": { "pixel": 0.1, "share": 0.2, "average": 0.3 },
    })");
    ASSERT_TRUE(read_file.file) << to_text(read_file.error);
    const SnapshotFile& file = *read_file.file;
    const RenderRequest& request = file.request;
    EXPECT_EQ(request.graph, (folder / "other.graph.json").string());
    EXPECT_EQ(request.mesh, "torus");
    EXPECT_EQ(request.size, 64);
    EXPECT_EQ(request.samples, 1);
    EXPECT_EQ(request.segments, 512);
    EXPECT_EQ(request.time, 1.5);
    EXPECT_EQ(request.options.preview, "mask");
    EXPECT_EQ(request.object, "wall");
    EXPECT_EQ(request.material, "brick");
    EXPECT_EQ(request.camera, "position=2,1,3 fov=40");
    EXPECT_EQ(request.ambient, "0.2");
    EXPECT_EQ(request.options.via, "cpu");
    EXPECT_EQ(request.lights, (std::vector<std::string>{"directional", "point range=3"}));
    EXPECT_EQ(request.overrides, (std::map<std::string, std::string>{{"_Roughness", "0.25"},
                                                                     {"_Tint", "1,0,0.5"},
                                                                     {"_On", "true"},
                                                                     {"_Mode", "Wet"},
                                                                     {"_MainTex", (folder / "rust.png").string()}}));
    EXPECT_EQ(file.tolerance.pixel, 0.1);
    EXPECT_EQ(file.tolerance.share, 0.2);
    EXPECT_EQ(file.tolerance.average, 0.3);
}

// The file may come after its settings, and is next to the snapshot.
TEST_F(SnapshotFileTest, ReadsTheSurroundings) {
    std::ofstream(folder / "sun set.hdr") << "x";
    const std::string file = (folder / "sun set.hdr").string();
    const auto environment = [&](const std::string& value) {
        const ReadSnapshot made = read(R"({ "patina": 1, "environment": )" + value + " }");
        return made.file ? made.file->request.environment : to_text(made.error);
    };
    EXPECT_EQ(environment(R"("sun set.hdr")"), file);
    EXPECT_EQ(environment(R"("none")"), "none");
    EXPECT_EQ(environment(R"({ "file": "sun set.hdr", "rotation": -90.5 })"), file + " rotation=-90.5");
    EXPECT_EQ(environment(R"({ "intensity": 2, "file": "sun set.hdr" })"), file + " intensity=2");
    const ReadSnapshot made = read(R"({ "patina": 1, "background": "none", "lighting": "phong" })");
    ASSERT_TRUE(made.file) << to_text(made.error);
    EXPECT_EQ(made.file->request.background, "none");
    EXPECT_EQ(made.file->request.options.lighting, "phong");
}

TEST_F(SnapshotFileTest, HasAsManyPicturesAsValuesButNotTooMany) {
    std::string values = "0";
    for (int i = 1; i < 100; i++) values += "," + std::to_string(i);
    const auto sweeps = [&](const std::string& second) {
        return R"({ "patina": 1, "sweep": { "_A": [)" + values + R"(], "_B": [)" + second + "] } }";
    };
    EXPECT_EQ(variations(*read(sweeps("0,1,2,3,4,5,6,7,8,9")).file).size(), 1000u);
    EXPECT_NE(to_text(read(sweeps(values)).error).find("at most 1000 pictures"), std::string::npos);
    EXPECT_EQ(variations(*read(R"({ "patina": 1 })").file).size(), 1u);
    EXPECT_TRUE(read(R"({ "patina": 1, "text": true })").file->text);
}

TEST_F(SnapshotFileTest, NoLightsAtAllIsAnEmptyArray) {
    EXPECT_EQ(read(R"({ "patina": 1, "lights": [] })").file->request.lights, std::vector<std::string>{"none"});
}

TEST_F(SnapshotFileTest, ErrorsHaveAPlaceAndAReason) {
    struct Case {
        const char* text;
        const char* place;
        const char* reason;
    };
    for (Case each : {Case{"{ \"patina\": 1,\n  \"mesch\": \"cube\" }", ":2:4: ", "unknown key 'mesch'"},
                      Case{R"({ "patina": 2 })", ":1:4: ", "version 1"},
                      Case{R"({ "mesh": "cube" })", ":1:1: ", "\"patina\": 1 is missing"},
                      Case{"", ":1:1: ", "the file is empty"},
                      Case{"[]", ":1:1: ", "array is not allowed here"},
                      Case{"3", ":1:1: ", "a snapshot is an object"},
                      Case{"{ \"patina\": 1,\n\n  \"size\": }", ":3:11: ", "broken JSON"},
                      Case{R"({ "patina": 1, "size": 0 })", ":1:17: ", "from 1 to 8192"},
                      Case{R"({ "patina": 1, "size": 1.5 })", ":1:17: ", "whole number"},
                      Case{R"({ "patina": 1, "size": 1e99 })", ":1:17: ", "from 1 to 8192"},
                      Case{R"({ "patina": 1, "segments": 513 })", ":1:17: ", "from 3 to 512"},
                      Case{R"({ "patina": 1, "time": "soon" })", ":1:17: ", "number of seconds"},
                      Case{R"({ "patina": 1, "time": 1e39 })", ":1:17: ", "number of seconds"},
                      Case{R"({ "patina": 1, "mesh": true })", ":1:17: ", "must be a text"},
                      Case{R"({ "patina": 1, "mesh": null })", ":1:17: ", "null is not allowed"},
                      Case{R"({ "patina": 1, "mesh": ["cube"] })", ":1:17: ", "array is not allowed here"},
                      Case{R"({ "patina": 1, "mesh": "teapot" })", ":1:17: ", "there is no mesh 'teapot'"},
                      Case{R"({ "patina": 1, "via": "metal" })", ":1:17: ", "glsl, hlsl or cpu"},
                      Case{R"({ "patina": 1, "ambient": "foo=1" })", ":1:17: ", "foo"},
                      Case{R"({ "patina": 1, "lights": ["foo"] })", ":1:17: ", "foo"},
                      Case{R"({ "patina": 1, "background": "foo" })", ":1:17: ", "foo"},
                      Case{R"({ "patina": 1, "lighting": 1 })", ":1:17: ", "'lighting' is a lighting model"},
                      Case{R"({ "patina": 1, "environment": "no.hdr" })", ":1:17: ", "there is no file '"},
                      Case{R"({ "patina": 1, "environment": 3 })", ":1:17: ", "'environment' is a picture"},
                      Case{R"({ "patina": 1, "environment": { "file": "studio" } })", ":1:34: ", "there is no file '"},
                      Case{R"({ "patina": 1, "environment": { "rotation": 1 } })", ":1:34: ", "needs 'file'"},
                      Case{R"({ "patina": 1, "environment": { "rotation": "1" } })", ":1:34: ", "is a number from"},
                      Case{R"({ "patina": 1, "environment": { "intensity": -1 } })", ":1:34: ", "is a number from 0"},
                      Case{R"({ "patina": 1, "environment": { "flie": "x" } })", ":1:34: ", "did you mean 'file'?"},
                      Case{R"({ "patina": 1, "environment": "none", "ambient": 1 })", ":1:40: ", "exclude each other"},
                      Case{R"({ "patina": 1, "camera": { "target": [0, 0, 1], "fov": 0 } })", ":1:50: ", "fov"},
                      Case{R"({ "patina": 1, "camera": { "fov": 3, "position": [1, 2] } })", ":1:39: ", "position"},
                      Case{R"({ "patina": 1, "patina": 1 })", ":1:17: ", "appears twice"},
                      Case{R"({ "patina": 1, "tolerance": { "pixels": 1 } })", ":1:32: ", "unknown key 'pixels'"},
                      Case{R"({ "patina": 1, "tolerance": { "pixel": 2 } })", ":1:32: ", "between 0 and 1"},
                      Case{R"({ "patina": 1, "tolerance": { "share": "1" } })", ":1:32: ", "'share' must be a number"},
                      Case{R"({ "patina": 1, "tolerance": { "otherDriver": 0.5 } })", ":1:32: ", "between 1 and 1000"},
                      Case{R"({ "patina": 1, "text": "yes" })", ":1:17: ", "'text' is true or false"},
                      Case{R"({ "patina": 1, "path": [] })", ":1:17: ", "or a list of names"},
                      Case{R"({ "patina": 1, "path": [1] })", ":1:17: ", "or a list of names"},
                      Case{R"({ "patina": 1, "path": "" })", ":1:17: ", "'path' is the name of a rendering path"},
                      Case{R"({ "patina": 1, "path": ["a", "a"] })", ":1:17: ", "the path 'a' appears twice"},
                      Case{R"({ "patina": 1, "sweep": [1] })", ":1:17: ", "'sweep' must be an object"},
                      Case{R"({ "patina": 1, "sweep": { "_A": 1 } })", ":1:28: ", "'_A' of a sweep is an array"},
                      Case{R"({ "patina": 1, "sweep": { "_A": [] } })", ":1:28: ", "'_A' of a sweep is an array"},
                      Case{R"({ "patina": 1, "sweep": { "_A": [1, 1] } })", ":1:28: ", "the value '1' appears twice"},
                      Case{R"({ "patina": 1, "tolerance": 1 })",
                           ":1:17: ", R"('tolerance' must be an object, such as { "pixel": 0.01 })"},
                      Case{R"({ "patina": 1, "set": [1] })", ":1:17: ", "'set' must be an object"},
                      Case{R"({ "patina": 1, "camera": "fov=40" })", ":1:17: ", "'camera' must be an object"},
                      Case{R"({ "patina": 1, "camera": { "fow": 40 } })", ":1:29: ", "unknown key 'fow' in a camera"},
                      Case{R"({ "patina": 1, "camera": { "fov": "40" } })", ":1:29: ", "'fov' of a camera is a number"},
                      Case{R"({ "patina": 1, "set": { "_A": { "b": 1 } } })", ":1:26: ", "object is not allowed here"},
                      Case{R"({ "patina": 1, "set": { "_A": ["b"] } })", ":1:26: ", "numbers only"},
                      Case{R"({ "patina": 1, "lights": [3] })", ":1:17: ", "a light is a text"}}) {
        ReadSnapshot read_file = read(each.text);
        ASSERT_FALSE(read_file.file) << each.text;
        const std::string error = to_text(read_file.error);
        EXPECT_NE(error.find("rust.snapshot.json" + std::string(each.place)), std::string::npos) << error;
        EXPECT_NE(error.find(each.reason), std::string::npos) << error;
    }
}

TEST_F(SnapshotFileTest, ErrorsShowTheirLineAndAFix) {
    const std::string text = to_text(read("{ \"patina\": 1,\n  \"mesch\": \"cube\" }").error);
    EXPECT_EQ(text, (folder / "rust.snapshot.json").string() +
                        ":2:4: error: unknown key 'mesch' in a snapshot [unknown-key]\n"
                        "    2 |   \"mesch\": \"cube\" }\n"
                        "      |    ^~~~~\n"
                        "note: did you mean 'mesh'?");
}

TEST_F(SnapshotFileTest, BracketsWithoutEndDoNotOverflowTheStack) {
    EXPECT_FALSE(read(std::string(1 << 20, '[')).file);
    std::string objects;
    for (int i = 0; i < 10000; i++) objects += "{\"a\":";
    EXPECT_FALSE(read(objects).file);
    EXPECT_FALSE(read(std::string((1 << 20) + 1, ' ')).file);
}

TEST_F(SnapshotFileTest, MissingFileIsAnError) {
    const std::string path = (folder / "none.snapshot.json").string();
    const ReadSnapshot none = read_snapshot(path);
    EXPECT_FALSE(none.file);
    EXPECT_EQ(to_text(none.error),
              path + ": error: cannot read '" + path + "': No such file or directory [cannot-read]");
}

}  // namespace
}  // namespace patina::runtime
