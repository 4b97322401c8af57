#include "runtime/snapshot_file.h"

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
    Outcome<SnapshotFile> read(const std::string& text) {
        std::ofstream(folder / "rust.snapshot.json", std::ios::binary) << text;
        return read_snapshot((folder / "rust.snapshot.json").string());
    }

    fs::path folder;
};

TEST_F(SnapshotFileTest, LeavesOutWhatHasDefaults) {
    Outcome<SnapshotFile> file = read(R"({ "patina": 1 })");
    ASSERT_TRUE(file) << file.error;
    EXPECT_EQ(file.value.request.graph, (folder / "rust.graph.json").string());
    EXPECT_EQ(file.value.request.size, 128);
    EXPECT_EQ(file.value.request.samples, 2);
    EXPECT_EQ(file.value.request.mesh, "sphere");
    EXPECT_TRUE(file.value.request.lights.empty());
}

TEST_F(SnapshotFileTest, ReadsEverything) {
    std::ofstream(folder / "rust.png") << "x";
    Outcome<SnapshotFile> file = read(R"({
        // a comment, and a trailing comma
        "patina": 1, "graph": "other.graph.json", "mesh": "torus", "size": 64, "samples": 1, "time": 1.5, "node": "mask",
        "camera": "fov=40", "ambient": 0.2, "via": "cpu", "lights": ["directional", "point range=3"],
        "set": { "_Roughness": 0.25, "_Tint": [1, 0, 0.5], "_On": true, "_Mode": "Wet", "_MainTex": "rust.png" },
        "tolerance": { "pixel": 0.1, "share": 0.2, "average": 0.3 },
    })");
    ASSERT_TRUE(file) << file.error;
    const RenderRequest& request = file.value.request;
    EXPECT_EQ(request.graph, (folder / "other.graph.json").string());
    EXPECT_EQ(request.mesh, "torus");
    EXPECT_EQ(request.size, 64);
    EXPECT_EQ(request.samples, 1);
    EXPECT_EQ(request.time, 1.5);
    EXPECT_EQ(request.preview, "mask");
    EXPECT_EQ(request.camera, "fov=40");
    EXPECT_EQ(request.ambient, "0.2");
    EXPECT_EQ(request.via, "cpu");
    EXPECT_EQ(request.lights, (std::vector<std::string>{"directional", "point range=3"}));
    EXPECT_EQ(request.overrides, (std::map<std::string, std::string>{{"_Roughness", "0.25"},
                                                                     {"_Tint", "1,0,0.5"},
                                                                     {"_On", "true"},
                                                                     {"_Mode", "Wet"},
                                                                     {"_MainTex", (folder / "rust.png").string()}}));
    EXPECT_EQ(file.value.tolerance.pixel, 0.1);
    EXPECT_EQ(file.value.tolerance.share, 0.2);
    EXPECT_EQ(file.value.tolerance.average, 0.3);
}

TEST_F(SnapshotFileTest, NoLightsAtAllIsAnEmptyArray) {
    EXPECT_EQ(read(R"({ "patina": 1, "lights": [] })").value.request.lights, std::vector<std::string>{"none"});
}

TEST_F(SnapshotFileTest, ErrorsHaveAPlaceAndAReason) {
    struct Case {
        const char* text;
        const char* place;
        const char* reason;
    };
    for (Case each : {Case{"{ \"patina\": 1,\n  \"mesch\": \"cube\" }", ":2:3: ", "unknown key 'mesch'"},
                      Case{R"({ "patina": 2 })", ":1:3: ", "version 1"},
                      Case{R"({ "mesh": "cube" })", ":1:1: ", "\"patina\": 1 is missing"},
                      Case{"", ":1:1: ", "broken JSON"},
                      Case{"[]", ":1:1: ", "array cannot stand here"},
                      Case{"3", ":1:1: ", "a snapshot is an object"},
                      Case{"{ \"patina\": 1,\n\n  \"size\": }", ":3:11: ", "broken JSON"},
                      Case{R"({ "patina": 1, "size": 0 })", ":1:16: ", "from 1 to 4096"},
                      Case{R"({ "patina": 1, "size": 1.5 })", ":1:16: ", "whole number"},
                      Case{R"({ "patina": 1, "size": 1e99 })", ":1:16: ", "from 1 to 4096"},
                      Case{R"({ "patina": 1, "time": "soon" })", ":1:16: ", "number of seconds"},
                      Case{R"({ "patina": 1, "mesh": true })", ":1:16: ", "must be a text"},
                      Case{R"({ "patina": 1, "mesh": null })", ":1:16: ", "null means nothing"},
                      Case{R"({ "patina": 1, "mesh": ["cube"] })", ":1:16: ", "array cannot stand here"},
                      Case{R"({ "patina": 1, "patina": 1 })", ":1:16: ", "here twice"},
                      Case{R"({ "patina": 1, "tolerance": { "pixels": 1 } })", ":1:31: ", "unknown key 'pixels'"},
                      Case{R"({ "patina": 1, "tolerance": { "pixel": 2 } })", ":1:31: ", "between 0 and 1"},
                      Case{R"({ "patina": 1, "set": { "_A": { "b": 1 } } })", ":1:25: ", "object cannot stand here"},
                      Case{R"({ "patina": 1, "set": { "_A": ["b"] } })", ":1:25: ", "numbers only"},
                      Case{R"({ "patina": 1, "lights": [3] })", ":1:16: ", "a light is a text"}}) {
        Outcome<SnapshotFile> file = read(each.text);
        ASSERT_FALSE(file) << each.text;
        EXPECT_NE(file.error.find("rust.snapshot.json" + std::string(each.place)), std::string::npos) << file.error;
        EXPECT_NE(file.error.find(each.reason), std::string::npos) << file.error;
    }
}

TEST_F(SnapshotFileTest, BracketsWithoutEndDoNotOverflowTheStack) {
    EXPECT_FALSE(read(std::string(1 << 20, '[')));
    std::string objects;
    for (int i = 0; i < 10000; i++) objects += "{\"a\":";
    EXPECT_FALSE(read(objects));
    EXPECT_FALSE(read(std::string((1 << 20) + 1, ' ')));
}

TEST_F(SnapshotFileTest, MissingFileIsAnError) {
    EXPECT_FALSE(read_snapshot((folder / "none.snapshot.json").string()));
}

}  // namespace
}  // namespace patina::runtime
