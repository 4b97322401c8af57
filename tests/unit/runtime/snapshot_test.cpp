// Snapshots of a folder: which there are, what a run says of them, and that only an update writes references.
#include "runtime/snapshot/snapshot.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <thread>

#include "runtime/picture/image.h"
#include "runtime/snapshot/find_cases.h"
#include "runtime/snapshot/report_data.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// A folder of unlit materials, which the CPU draws.
class Snapshots : public testing::Test {
protected:
    Snapshots() {
        std::string name = (fs::temp_directory_path() / "patina_snapshots_XXXXXX").string();
        root = mkdtemp(name.data());
        folder = root / "art";
        fs::create_directory(folder);
        options.received_dir = (root / "received").string();
        options.via = "cpu";
    }
    ~Snapshots() override { fs::remove_all(root); }

    void write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    void write_graph(const std::string& name, const std::string& color) const {
        write(name,
              R"({ "patina": 1, "workflow": "unlit", "properties": [ { "name": "_C", "type": "float", "default": )" +
                  color + R"( } ], "surface": { "color": "$_C" } })");
    }
    SnapshotReport run() const { return run_snapshots(compiler(), folder.string(), options); }
    SnapshotReport update() {
        options.update = true;
        SnapshotReport report = run();
        options.update = false;
        return report;
    }
    std::vector<std::string> names() const {
        std::vector<std::string> result;
        for (const PlannedCase& each : find_cases(folder.string()).cases) result.push_back(each.name);
        return result;
    }
    static const Compiler& compiler() {
        static const Compiler shared;
        return shared;
    }

    fs::path root, folder;
    SnapshotOptions options{};
};

using Names = std::vector<std::string>;

// --- which there are

TEST_F(Snapshots, AreGraphsAndScenesThatNoFileShowsAndTheFiles) {
    write_graph("rust.graph.json", "0.5");
    write("room.scene.json", "{}");
    write_graph("deep/er/wood.graph.json", "0.5");
    write_graph("shown.graph.json", "0.5");
    write("other.snapshot.json", R"({ "patina": 1, "graph": "deep/../shown.graph.json" })");
    write_graph(".hidden/x.graph.json", "0.5");
    write("part.subgraph.json", "{}");
    write("own.lighting.json", "{}");
    EXPECT_EQ(names(), (Names{"deep/er/wood", "other", "room", "rust"}));
}

TEST_F(Snapshots, AFileHasAPictureForEachPathAndValue) {
    write_graph("rust.graph.json", "0.5");
    write(
        "rust.snapshot.json",
        R"({ "patina": 1, "path": ["forward", "./mine.pass.hlsl"], "sweep": { "_A": [0, 1], "_Tint": ["#ff0000", "x/y.png"] } })");
    EXPECT_EQ(names(),
              (Names{"rust.forward._A=0._Tint=_ff0000", "rust.forward._A=0._Tint=y.png",
                     "rust.forward._A=1._Tint=_ff0000", "rust.forward._A=1._Tint=y.png", "rust.mine._A=0._Tint=_ff0000",
                     "rust.mine._A=0._Tint=y.png", "rust.mine._A=1._Tint=_ff0000", "rust.mine._A=1._Tint=y.png"}));
    const PlannedCase last = find_cases(folder.string()).cases.back();
    EXPECT_EQ(last.base, "rust");
    EXPECT_EQ(last.request.options.path, (folder / "./mine.pass.hlsl").string());
    EXPECT_EQ(last.request.overrides.at("_A"), "1");
    EXPECT_EQ(last.picture(), (folder / "rust.mine._A=1._Tint=y.png.reference.png").string());
}

TEST_F(Snapshots, TwoCasesOfOneReferenceAreAnError) {
    write_graph("rust.graph.json", "0.5");
    write("rust.scene.json", "{}");
    const FoundCases found = find_cases(folder.string());
    ASSERT_EQ(found.cases.size(), 2u);
    EXPECT_FALSE(found.cases[0].problem);
    ASSERT_TRUE(found.cases[1].problem);
    EXPECT_NE(found.cases[1].problem->message.find("would have the same reference"), std::string::npos);
    EXPECT_EQ(found.cases[1].problem->file, (folder / "rust.scene.json").string());
}

TEST_F(Snapshots, AReferenceOfNoCaseIsFound) {
    write_graph("rust.graph.json", "0.5");
    write("rust.reference.png", "");
    write("gone.reference.png", "");
    write("broken.snapshot.json", "{");
    write("broken.deferred.reference.png", "");
    EXPECT_EQ(find_cases(folder.string()).orphans, Names{(folder / "gone.reference.png").string()});
}

// --- what a run says

TEST_F(Snapshots, AMissingReferenceFailsAndSaysHowToMakeIt) {
    write_graph("rust.graph.json", "0.5");
    const SnapshotReport report = run();
    ASSERT_EQ(report.cases.size(), 1u);
    EXPECT_FALSE(report.ok());
    EXPECT_EQ(report.cases[0].state, SnapshotState::Missing);
    EXPECT_NE(report.cases[0].message.find("'patina snapshot " + folder.string() + " --update rust'"),
              std::string::npos)
        << report.cases[0].message;
    EXPECT_TRUE(fs::exists(root / "received/rust.received.png"));
    EXPECT_FALSE(fs::exists(folder / "rust.reference.png"));
}

TEST_F(Snapshots, OnlyAnUpdateChangesAReference) {
    write_graph("rust.graph.json", "0.5");
    EXPECT_EQ(update().cases[0].state, SnapshotState::Updated);
    EXPECT_EQ(run().cases[0].state, SnapshotState::Passed);
    const std::string before = read(folder / "rust.reference.png");
    EXPECT_EQ(update().cases[0].state, SnapshotState::Passed);  // nothing to accept
    EXPECT_EQ(read(folder / "rust.reference.png"), before);
    write_graph("rust.graph.json", "1");
    const SnapshotReport failed = run();
    EXPECT_EQ(failed.cases[0].state, SnapshotState::Failed);
    EXPECT_EQ(read(folder / "rust.reference.png"), before);
    EXPECT_TRUE(fs::exists(root / "received/rust.difference.png"));
    EXPECT_EQ(update().cases[0].state, SnapshotState::Updated);
    EXPECT_NE(read(folder / "rust.reference.png"), before);
    EXPECT_EQ(run().cases[0].state, SnapshotState::Passed);
    EXPECT_FALSE(fs::exists(root / "received/rust.difference.png")) << "of an earlier run";
}

TEST_F(Snapshots, AReferenceThatIsNoPictureFailsAndCanBeReplaced) {
    write_graph("rust.graph.json", "0.5");
    write_graph("wood.graph.json", "0.5");
    write("rust.reference.png", "no picture");
    fs::create_directory(folder / "wood.reference.png");
    const SnapshotReport report = run();
    ASSERT_EQ(report.cases.size(), 2u);
    EXPECT_NE(report.cases[0].message.find("as an image"), std::string::npos) << report.cases[0].message;
    EXPECT_NE(report.cases[1].message.find("it is a folder"), std::string::npos) << report.cases[1].message;
    const SnapshotReport updated = update();
    EXPECT_EQ(updated.cases[0].state, SnapshotState::Updated);
    EXPECT_EQ(updated.cases[1].state, SnapshotState::Failed);
    EXPECT_NE(updated.cases[1].message.find("cannot write"), std::string::npos) << updated.cases[1].message;
    EXPECT_EQ(run().cases[0].state, SnapshotState::Passed);
}

// A reference in which a rectangle has another red: what each gate says of it follows from how it was made.
TEST_F(Snapshots, EachGateHasItsFigure) {
    write_graph("rust.graph.json", "0.5");
    write("rust.snapshot.json", R"({ "patina": 1, "size": 32, "mesh": "plane" })");
    ASSERT_TRUE(update().ok());
    Image reference = load_image((folder / "rust.reference.png").string()).value;
    for (int y = 16; y < 32; y++)
        for (int x = 0; x < 8; x++) reference.at(x, y)[0] += reference.at(x, y)[0] > 0.5f ? -0.2f : 0.2f;
    const Outcome<std::string> png = encode_png_as_is(reference, load_notes((folder / "rust.reference.png").string()));
    write("rust.reference.png", png.value);
    const SnapshotCase result = run().cases.at(0);
    EXPECT_EQ(result.state, SnapshotState::Failed);
    ASSERT_EQ(result.gates.size(), 4u);
    // 8 x 16 of 32 x 32 pixels differ, in one of four channels, by 51 / 255. They are half of one tile.
    EXPECT_EQ(result.gates[0].name, "share");
    EXPECT_DOUBLE_EQ(result.gates[0].value, 0.125);
    EXPECT_NEAR(result.gates[1].value, 0.125 * 0.2 / 4, 1e-7);
    EXPECT_NEAR(result.gates[2].value, 0.5 * 0.2 / 4, 1e-7);
    EXPECT_GT(result.gates[3].value, 0.01);
    EXPECT_LT(result.gates[3].value, 0.25);
    for (const char* each : {"share", "average", "tile", "perceptual"}) {
        // A limit at the figure lets it pass, and one below does not.
        for (const Gate& gate : result.gates) options.tolerance[std::string(gate.name)] = gate.value;
        EXPECT_TRUE(run().ok());
        options.tolerance[each] *= 0.99;
        EXPECT_FALSE(run().ok()) << each;
    }
    options.tolerance = {{"pixel", 0.21}, {"average", 1}, {"tile", 1}, {"perceptual", 1}};
    EXPECT_TRUE(run().ok()) << "no channel is off by more than 0.2";
}

TEST_F(Snapshots, AnotherDriverWidensTheLimits) {
    write_graph("rust.graph.json", "0.5");
    write("rust.snapshot.json",
          R"({ "patina": 1, "size": 32, "mesh": "plane", "tolerance": { "share": 0.01, "average": 0.001, "tile": 1,
               "perceptual": 1, "otherDriver": 4 } })");
    ASSERT_TRUE(update().ok());
    const fs::path file = folder / "rust.reference.png";
    PictureNotes notes = load_notes(file.string());
    EXPECT_EQ(notes.at("Patina Device"), "CPU reference");
    // 3 of 100 pixels differ: over a limit of 1 %, and under one of 4 %.
    Image reference = load_image(file.string()).value;
    for (int x = 0; x < 31; x++) reference.at(x, 16)[0] += 0.1f;
    write("rust.reference.png", encode_png_as_is(reference, notes).value);
    EXPECT_FALSE(run().ok());
    notes["Patina Driver"] = "an older one";
    write("rust.reference.png", encode_png_as_is(reference, notes).value);
    const SnapshotReport wide = run();
    EXPECT_TRUE(wide.ok());
    EXPECT_TRUE(wide.cases[0].other_driver);
    EXPECT_DOUBLE_EQ(wide.cases[0].gates[0].limit, 0.04);
    EXPECT_DOUBLE_EQ(wide.cases[0].gates[1].limit, 0.004);
    EXPECT_DOUBLE_EQ(wide.cases[0].gates[2].limit, 1);
    // A reference that does not say what drew it is compared as one of this machine.
    write("rust.reference.png", encode_png_as_is(reference).value);
    EXPECT_FALSE(run().ok());
}

// --- shaders

TEST_F(Snapshots, TheShadersAreComparedWithTheirReference) {
    options.via.clear();
    write_graph("rust.graph.json", "0.5");
    write("rust.snapshot.json", R"({ "patina": 1, "size": 8, "text": true, "via": "cpu" })");
    EXPECT_EQ(run().cases[0].state, SnapshotState::Missing);
    ASSERT_TRUE(update().ok());
    const fs::path file = folder / "rust.reference.glsl";
    const std::string text = read(file);
    EXPECT_TRUE(text.starts_with("// --- rust.forward.vert.glsl\n// rust, ")) << text;
    EXPECT_EQ(text.find("Generated by"), std::string::npos) << "a new version alone changes no reference";
    EXPECT_NE(text.find("\n// --- rust.forward.frag.glsl\n"), std::string::npos);
    EXPECT_TRUE(run().ok());

    std::string other = text;
    other.insert(other.find("void main"), "// a line that is gone\n");
    write("rust.reference.glsl", other);
    const SnapshotCase failed = run().cases[0];
    EXPECT_EQ(failed.state, SnapshotState::Failed);
    EXPECT_EQ(changed_lines(failed.text_diff), 1u);
    EXPECT_EQ(read(root / "received/rust.received.glsl"), text);
    EXPECT_EQ(read(file), other);
    EXPECT_EQ(update().cases[0].state, SnapshotState::Updated);
    EXPECT_EQ(read(file), text);

    fs::remove(file);
    EXPECT_EQ(run().cases[0].state, SnapshotState::Missing);
}

// --- several at once

TEST_F(Snapshots, ShardsHaveEveryCaseOnce) {
    for (const char* name : {"a", "b", "c", "d", "e"}) write_graph(std::string(name) + ".graph.json", "0.5");
    Names all;
    for (std::size_t i = 1; i <= 3; i++) {
        options.shard = {.index = i, .count = 3};
        const SnapshotReport part = run();
        EXPECT_LE(part.cases.size(), 2u);
        for (const SnapshotCase& each : part.cases) all.push_back(each.name);
    }
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, (Names{"a", "b", "c", "d", "e"}));
    options.shard = {.index = 9, .count = 9};
    EXPECT_TRUE(run().ok()) << "a shard without cases";
    options.shard = {};
    options.only = "f";
    EXPECT_NE(run().error.find("there is no case 'f'"), std::string::npos);
}

TEST_F(Snapshots, JobsChangeNeitherTheResultsNorTheirOrder) {
    for (int i = 0; i < 9; i++) write_graph("ball" + std::to_string(i) + ".graph.json", "0." + std::to_string(i));
    ASSERT_TRUE(update().ok());
    write_graph("ball3.graph.json", "1");
    std::string expected;
    for (int jobs : {1, 2, 5}) {
        options.jobs = jobs;
        Names told;
        options.on_case = [&](const SnapshotCase& each, std::size_t index, std::size_t count) {
            EXPECT_EQ(index, told.size());
            EXPECT_EQ(count, 9u);
            told.push_back(each.name);
        };
        const SnapshotReport report = run();
        EXPECT_EQ(report.count(SnapshotState::Failed), 1u);
        EXPECT_EQ(told.size(), 9u);
        EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
        const std::string json = report_json(report);
        if (expected.empty()) expected = json;
        EXPECT_EQ(json, expected) << jobs << " jobs";
    }
}

TEST_F(Snapshots, ReportsNameWhatIsWrong) {
    write_graph("a<b>&.graph.json", "0.5");
    write("broken.graph.json", "{");
    const SnapshotReport report = run();
    const std::string xml = report_junit(report, "art"), json = report_json(report);
    EXPECT_NE(xml.find(R"(<testsuite name="art" tests="2" failures="1" errors="1")"), std::string::npos) << xml;
    EXPECT_NE(xml.find(R"(<testcase name="a&lt;b&gt;&amp;")"), std::string::npos) << xml;
    EXPECT_NE(json.find(R"("state": "missing")"), std::string::npos) << json;
    EXPECT_NE(json.find("bad-json"), std::string::npos) << json;
    EXPECT_NE(json.find("\"failed\": 1,\n  \"missing\": 1,\n"), std::string::npos) << json;
}

}  // namespace
}  // namespace patina::runtime
