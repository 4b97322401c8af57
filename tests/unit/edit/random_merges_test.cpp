// Generated merges. A graph is a tree of values with keys that no rename touches; two sides change copies of it. What
// the merge should be is known from the values alone: each is the side's that changed it. So every merge is checked
// three ways: a clean one holds all changes and nothing else; it compiles; and whatever the values allow and compiles
// is clean. A conflict names both sides, and both of its sides compile. MERGE_SEED=17 prints and runs only that one.
#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>

#include "patina/graph_merge.h"
#include "unit/edit/author.h"
#include "unit/edit/side_readers.h"

namespace patina {
namespace {

// --- what a merge should be

struct Wanted {
    std::optional<Values> values{};  // nothing: a conflict
    // A side changed a thing together with its name, or several names. Whether a merge sees a rename is its own matter.
    bool may_conflict = false;
    // A side removed a thing and added another one, which may be a rename to a merge.
    bool is_open = false;
};

bool is_thing(const std::string& path) {
    return path.find('/') != path.npos && path.find('/', path.find('/') + 1) == path.npos &&
           (path.starts_with("nodes/") || path.starts_with("properties/"));
}
bool is_name(const std::string& path) {
    return path.ends_with("/id") || path.ends_with("/name");
}
bool is_place(const std::string& path) {
    return path.ends_with("/@place");
}

std::set<std::string> changed_paths(const Values& before, const Values& after) {
    std::set<std::string> paths;
    for (const auto& [path, value] : before) {
        if (!after.count(path) || at(after, path) != value) paths.insert(path);
    }
    for (const auto& [path, value] : after) {
        if (!before.count(path)) paths.insert(path);
    }
    return paths;
}

std::vector<int> property_order(const Values& values, const Values& a, const Values& b) {
    std::vector<int> keys;
    for (int key : keys_of(values, "properties")) {
        if (a.count(property(key)) && b.count(property(key))) keys.push_back(key);
    }
    const auto place = [&](int key) { return std::stoi(at(values, property(key) + "/@place")); };
    std::stable_sort(keys.begin(), keys.end(), [&](int x, int y) { return place(x) < place(y); });
    return keys;
}

void judge_side(const Values& base, const Values& side, Wanted& wanted) {
    const std::set<std::string> changed = changed_paths(base, side);
    int renames = 0;
    for (const std::string& path : changed) {
        if (is_thing(path) && base.count(path)) {
            for (const std::string& other : changed)
                wanted.is_open |= is_thing(other) && !base.count(other) && other[0] == path[0];
        }
        if (!is_name(path) || !base.count(path) || !side.count(path)) continue;
        ++renames;
        const std::string thing = path.substr(0, path.rfind('/'));
        for (const std::string& other : changed)
            wanted.may_conflict |= other != path && is_below(other, thing) && !is_place(other);
        // A property whose readers changed, too, may not be recognised.
        wanted.may_conflict |= thing[0] == 'p' && changed.size() > 1;
    }
    wanted.may_conflict |= renames > 1;
}

std::optional<Values> merged_values(const Values& base, const Values& ours, const Values& theirs) {
    const std::set<std::string> by_ours = changed_paths(base, ours), by_theirs = changed_paths(base, theirs);
    Values merged = base;
    for (const auto& [by, side] : {std::pair(&by_ours, &ours), std::pair(&by_theirs, &theirs)}) {
        for (const std::string& path : *by) {
            if (side->count(path)) {
                merged[path] = at(*side, path);
            } else {
                merged.erase(path);
            }
        }
    }
    for (const std::string& path : by_ours) {
        const bool is_same = ours.count(path) == theirs.count(path) && at(ours, path) == at(theirs, path);
        if (by_theirs.count(path) && !is_same && !is_place(path)) return std::nullopt;
    }
    // What one side removed, the other one left alone.
    const auto keeps_what_is_gone = [&](const Values& side, const std::set<std::string>& by_other,
                                        const Values& other) {
        return std::any_of(base.begin(), base.end(), [&](const auto& each) {
            if (!each.second.empty() || side.count(each.first) || !other.count(each.first)) return false;
            return std::any_of(by_other.begin(), by_other.end(),
                               [&](const std::string& path) { return is_below(path, each.first) && !is_place(path); });
        });
    };
    if (keeps_what_is_gone(ours, by_theirs, theirs) || keeps_what_is_gone(theirs, by_ours, ours)) return std::nullopt;
    std::set<std::string> names;
    for (const auto& [path, value] : merged) {
        if (is_name(path) && !names.insert(value).second) return std::nullopt;
    }
    return merged;
}

// --- documents without layout and order

void sort_members(rapidjson::Value& value) {
    if (value.IsObject()) {
        std::sort(value.MemberBegin(), value.MemberEnd(), [](const auto& a, const auto& b) {
            return std::string_view(a.name.GetString()) < std::string_view(b.name.GetString());
        });
        for (auto& member : value.GetObject()) sort_members(member.value);
    } else if (value.IsArray() && !value.Empty() && value[0].IsObject()) {
        for (auto& element : value.GetArray()) sort_members(element);
        const auto name = [](const rapidjson::Value& each) {
            return std::string_view(each.HasMember("id") ? each["id"].GetString() : each["name"].GetString());
        };
        std::sort(value.Begin(), value.End(), [&](const auto& a, const auto& b) { return name(a) < name(b); });
    }
}

struct Document {
    std::string sorted;
    std::vector<std::string> properties;  // in order
};

Document document_of(const std::string& text) {
    rapidjson::Document json;
    json.Parse<rapidjson::kParseCommentsFlag>(text.c_str());
    Document document;
    if (json.HasParseError()) return document;
    if (json.HasMember("properties")) {
        for (const auto& each : json["properties"].GetArray()) document.properties.push_back(each["name"].GetString());
    }
    for (const char* list : {"properties", "nodes"}) {
        if (json.HasMember(list) && json[list].Empty()) json.RemoveMember(list);  // as if it were not there
    }
    sort_members(json);
    rapidjson::StringBuffer buffer;
    rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
    json.Accept(writer);
    document.sorted = buffer.GetString();
    return document;
}

std::string side_of(const std::string& text, bool ours) {
    std::string made;
    char in = ' ';
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin) + 1;
        const std::string line = text.substr(begin, end - begin);
        begin = end;
        const bool is_marker =
            line.starts_with("<<<<<<<") || line.starts_with("=======") || line.starts_with(">>>>>>>");
        if (is_marker) {
            in = line[0];
        } else if (in != (ours ? '=' : '<')) {
            made += line;
        }
    }
    return made;
}

// --- the test

class RandomMerges : public testing::Test {
protected:
    struct Tally {
        int clean = 0, conflicts = 0, needless = 0, open = 0, failures = 0;
        int names = 0;  // of different things, in one side of a conflict
    };

    bool compiles(const std::string& text) {
        CompileOptions options;
        options.targets = {Target::Glsl};
        return compiler_.compile_text("any.graph.json", text, options).ok;
    }

    // A copy of the base with some changes, which compiles.
    Values changed(const Values& base, Dice& dice, int first_key) {
        for (;;) {
            Values values = base;
            Author author(values, dice, first_key);
            for (int i = 0, count = 1 + dice.below(4); i < count; ++i) author.change();
            if (compiles(Writer(values, nullptr).write())) return values;
        }
    }

    std::string text_of(const Values& values, Dice& dice) {
        Dice mess(static_cast<unsigned>(dice.below(1 << 20)));
        const std::string text = Writer(values, &mess).write();
        return dice.chance(50) ? compiler_.format("a.graph.json", text).text : text;
    }

    void run(unsigned seed, Tally& tally, bool prints) {
        Dice dice(seed);
        Values base;
        do {
            base.clear();
            Author(base, dice, 0).make_base();
        } while (!compiles(Writer(base, nullptr).write()));
        const Values ours = changed(base, dice, 1000), theirs = changed(base, dice, 2000);
        const std::string texts[] = {text_of(base, dice), text_of(ours, dice), text_of(theirs, dice)};
        const MergeResult merged = merge_graphs(compiler_, {"base.json", texts[0]}, {"ours.json", texts[1]},
                                                {"theirs.json", texts[2]}, {.path = "merged.graph.json"});
        std::string said;
        for (const Diagnostic& each : merged.diagnostics) said += to_text(each) + "\n";
        const std::string all = "seed " + std::to_string(seed) + "\n--- base\n" + texts[0] + "--- ours\n" + texts[1] +
                                "--- theirs\n" + texts[2] + "--- merged\n" + merged.text + said;
        if (prints) std::printf("%s", all.c_str());

        Wanted wanted;
        judge_side(base, ours, wanted);
        judge_side(base, theirs, wanted);
        wanted.values = merged_values(base, ours, theirs);
        std::string problem = wanted.is_open ? problem_of_open(merged) : problem_of(wanted, base, ours, theirs, merged);
        if (problem.empty()) problem = problem_of_names(merged, ours, theirs, tally);
        ++(merged.state == MergeState::Clean ? tally.clean : tally.conflicts);
        tally.open += wanted.is_open;
        if (wanted.values && merged.state != MergeState::Clean && wanted.may_conflict) ++tally.needless;
        if (problem.empty()) return;
        ++tally.failures;
        ADD_FAILURE() << problem << "\n" << all;
    }

    // Gives one name to two things that the sides have added or renamed. False: there are none.
    static bool share_a_name(const Values& base, const Values& ours, Values& theirs, Dice& dice) {
        const auto new_names = [&](const Values& side) {
            std::vector<std::string> paths;
            for (const auto& [path, value] : side) {
                if (is_name(path) && at(base, path) != value) paths.push_back(path);
            }
            return paths;
        };
        for (const std::string& path : new_names(theirs)) {
            for (const std::string& other : new_names(ours)) {
                if (path == other || path[0] != other[0] || dice.chance(20)) continue;
                theirs[path] = at(ours, other);
                return true;
            }
        }
        return false;
    }

    // Names of two things: both sides take one name, or one side gives names to other things. A merge reads what both
    // authors meant.
    void run_names(unsigned seed, Tally& tally, bool prints, bool both_take) {
        Dice dice(seed);
        Values base, ours, theirs;
        Wanted wanted;
        for (bool is_made = false; !is_made;) {
            base.clear();
            Author(base, dice, 0).make_base();
            if (!compiles(Writer(base, nullptr).write())) continue;
            ours = both_take ? changed(base, dice, 1000) : base;
            if (both_take) {
                theirs = changed(base, dice, 2000);
                is_made = share_a_name(base, ours, theirs, dice) && compiles(Writer(theirs, nullptr).write());
            } else {
                is_made = Author(ours, dice, 1000).reuse_a_name() && compiles(Writer(ours, nullptr).write());
                if (is_made) theirs = changed(base, dice, 2000);
            }
        }
        if (both_take) judge_side(base, ours, wanted);
        judge_side(base, theirs, wanted);
        if (dice.chance(50)) std::swap(ours, theirs);
        const std::string texts[] = {text_of(base, dice), text_of(ours, dice), text_of(theirs, dice)};
        const MergeResult merged = merge_graphs(compiler_, {"base.json", texts[0]}, {"ours.json", texts[1]},
                                                {"theirs.json", texts[2]}, {.path = "merged.graph.json"});
        const bool is_clean = merged.state == MergeState::Clean;
        ++(is_clean ? tally.clean : tally.conflicts);
        tally.open += wanted.is_open;
        wanted.values = merged_values(base, ours, theirs);
        std::string problem, text;
        if (!is_clean || wanted.is_open) {
            problem = problem_of_open(merged);
        } else if (wanted.values) {
            text = Writer(*wanted.values, nullptr).write();
            if (document_of(merged.text).sorted != document_of(text).sorted) problem = "the merge should be";
        } else if (!wanted.may_conflict && !both_take) {  // both may have made the same
            problem = "this is a conflict, but the merge is clean";
        }
        if (problem.empty()) problem = problem_of_names(merged, ours, theirs, tally);
        if (problem.empty() && !prints) return;
        std::string said;
        for (const Diagnostic& each : merged.diagnostics) said += to_text(each) + "\n";
        const std::string all = problem + "\n" + text + "seed " + std::to_string(seed) + "\n--- base\n" + texts[0] +
                                "--- ours\n" + texts[1] + "--- theirs\n" + texts[2] + "--- merged\n" + merged.text +
                                said;
        if (prints) std::printf("%s", all.c_str());
        if (problem.empty()) return;
        ++tally.failures;
        ADD_FAILURE() << all;
    }

    // Who takes one side everywhere gets readers that read what their author meant.
    static std::string problem_of_names(const MergeResult& merged, const Values& ours, const Values& theirs,
                                        Tally& tally) {
        for (const bool is_ours : {true, false}) {
            const std::string problem = misread_name(ours, theirs, side_of(merged.text, is_ours), tally.names);
            if (!problem.empty()) return (is_ours ? "with ours, " : "with theirs, ") + problem;
        }
        return {};
    }

    std::string problem_of_open(const MergeResult& merged) {
        if (merged.state == MergeState::Clean) return compiles(merged.text) ? "" : "a clean merge does not compile";
        return problem_of_conflict(merged);
    }

    std::string problem_of_conflict(const MergeResult& merged) {
        if (merged.diagnostics.empty()) return "a conflict says nothing";
        for (const Diagnostic& each : merged.diagnostics) {
            if (each.severity == Severity::Note) continue;  // of comments
            const auto says = [&](const char* side) {
                return std::any_of(each.notes.begin(), each.notes.end(), [&](const Diagnostic& note) {
                    return note.message.starts_with(side) && note.line > 0;
                });
            };
            if (!says("ours: ") || !says("theirs: ")) return "a conflict does not name both sides";
        }
        if (merged.text.find("<<<<<<<") == merged.text.npos) return "there are no markers";
        for (const bool ours : {true, false}) {
            if (!compiles(side_of(merged.text, ours)))
                return std::string(ours ? "ours" : "theirs") + " between the markers does not compile";
        }
        return {};
    }

    std::string problem_of(const Wanted& wanted, const Values& base, const Values& ours, const Values& theirs,
                           const MergeResult& merged) {
        const std::vector<int> base_order = property_order(base, ours, theirs);
        const std::vector<int> our_order = property_order(ours, base, theirs);
        const std::vector<int> their_order = property_order(theirs, base, ours);
        const bool orders_clash = our_order != base_order && their_order != base_order && our_order != their_order;
        const std::string text = wanted.values ? Writer(*wanted.values, nullptr).write() : "";
        const bool is_clean = wanted.values && !orders_clash && compiles(text);
        if (merged.state != MergeState::Clean) {
            if (is_clean && !wanted.may_conflict) return "this is no conflict; the merge is\n" + text;
            return problem_of_conflict(merged);
        }
        if (!is_clean && wanted.may_conflict) return compiles(merged.text) ? "" : "a clean merge does not compile";
        if (!is_clean) return "this is a conflict, but the merge is clean";
        if (!compiles(merged.text)) return "a clean merge does not compile";
        const Document made = document_of(merged.text), right = document_of(text);
        if (made.sorted != right.sorted) return "the merge should be\n" + text;
        std::vector<std::string> order;
        for (int key : their_order != base_order ? their_order : our_order)
            order.push_back(at(*wanted.values, property(key) + "/name"));
        std::vector<std::string> made_order;
        for (const std::string& name : made.properties) {
            if (std::find(order.begin(), order.end(), name) != order.end()) made_order.push_back(name);
        }
        return made_order == order || wanted.may_conflict ? "" : "the properties are in another order";
    }

    void run_all(unsigned begin, unsigned end) {
        const char* only = std::getenv("MERGE_SEED");
        if (only) begin = static_cast<unsigned>(std::atoi(only)), end = begin + 1;
        Tally tally;
        for (unsigned seed = begin; seed < end && tally.failures < 3; ++seed) run(seed, tally, only != nullptr);
        std::printf(
            "%d clean, %d conflicts (%d of them where values alone would merge); %d where a rename is open; %d names "
            "of "
            "two things\n",
            tally.clean, tally.conflicts, tally.needless, tally.open, tally.names);
        if (only) return;
        // Else the merges prove little.
        EXPECT_GT(tally.clean, tally.conflicts / 2);
        EXPECT_GT(tally.conflicts, tally.clean / 4);
        EXPECT_LT(tally.open, (tally.clean + tally.conflicts) / 3);
    }

    void run_all_names(bool both_take) {
        const char* only = std::getenv("MERGE_SEED");
        const unsigned begin = only ? static_cast<unsigned>(std::atoi(only)) : 0;
        const unsigned end = only ? begin + 1 : both_take ? 400 : 1000;
        Tally tally;
        for (unsigned seed = begin; seed < end && tally.failures < 3; ++seed)
            run_names(seed, tally, only != nullptr, both_take);
        std::printf("%d clean, %d conflicts; %d where a rename is open; %d names of two things\n", tally.clean,
                    tally.conflicts, tally.open, tally.names);
        if (only) return;
        EXPECT_GT(tally.names, 500);
        EXPECT_GT(tally.conflicts, tally.clean / 4);
        EXPECT_GT(tally.clean, both_take ? 0 : tally.conflicts / 4);
    }

    Compiler compiler_;
};

TEST_F(RandomMerges, Quick) {
    run_all(0, 300);
}

TEST_F(RandomMerges, OfNamesThatAreUsedAgain) {
    run_all_names(false);
}

TEST_F(RandomMerges, OfNamesThatBothSidesTake) {
    run_all_names(true);
}

TEST_F(RandomMerges, TenThousand) {
    run_all(300, 10'300);
}

}  // namespace
}  // namespace patina
