// Writes materials as Unity does, in the form of today and in that of version 5, with the few lines that a test names.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace patina::importers {

struct TextureText {
    std::string name{}, guid{};  // empty: no texture
    std::string scale = "{x: 1, y: 1}", offset = "{x: 0, y: 0}";
};
struct ValueText {
    std::string name{}, value{};  // "_Metallic", "0.5"; "_Color", "{r: 1, g: 0, b: 0, a: 1}"
};

inline constexpr const char* kStandard = "{fileID: 46, guid: 0000000000000000f000000000000000, type: 0}";
inline constexpr const char* kStandardSpecular = "{fileID: 45, guid: 0000000000000000f000000000000000, type: 0}";
inline constexpr const char* kLit = "{fileID: 4800000, guid: 933532a4fcc9baf4fa0491de14d08ed7, type: 3}";
inline constexpr const char* kComplexLit = "{fileID: 4800000, guid: ee7e4c9a5f6364b688a332c67fc32cca, type: 3}";
inline constexpr const char* kSimpleLit = "{fileID: 4800000, guid: 8d2bb70cbf9db8d4da26e15b26e74248, type: 3}";
inline constexpr const char* kBakedLit = "{fileID: 4800000, guid: 0ca6dca7396eb48e5849247ffd444914, type: 3}";
inline constexpr const char* kUnlit = "{fileID: 4800000, guid: 650dd9526735d5b46b79224bc6e94025, type: 3}";

struct MaterialText {
    std::string shader = kStandard;
    std::vector<std::string> keywords{};
    std::vector<TextureText> textures{};
    std::vector<ValueText> numbers{}, colors{};
    std::string queue = "-1";
    std::string parent = "{fileID: 0}";
    std::string modified = "0";
    std::vector<std::string> invalid_keywords{}, disabled_passes{};
    std::string tags{};  // "RenderType: Transparent"

    std::string text() const {
        std::string made = R"(%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!114 &-7511754225479150587
MonoBehaviour:
  m_ObjectHideFlags: 11
  m_Name: 
  m_EditorClassIdentifier: 
  version: 7
--- !u!21 &2100000
Material:
  serializedVersion: 8
  m_ObjectHideFlags: 0
  m_CorrespondingSourceObject: {fileID: 0}
  m_PrefabInstance: {fileID: 0}
  m_PrefabAsset: {fileID: 0}
  m_Name: x
)";
        made += fmt::format("  m_Shader: {}\n  m_Parent: {}\n  m_ModifiedSerializedProperties: {}\n", shader, parent,
                            modified);
        made += "  m_ValidKeywords:" + list(keywords, "  ") + "  m_InvalidKeywords:" + list(invalid_keywords, "  ");
        made += "  m_LightmapFlags: 4\n  m_EnableInstancingVariants: 0\n  m_DoubleSidedGI: 0\n";
        made += fmt::format("  m_CustomRenderQueue: {}\n", queue);
        made += tags.empty() ? "  stringTagMap: {}\n" : fmt::format("  stringTagMap:\n    {}\n", tags);
        made += "  disabledShaderPasses:" + list(disabled_passes, "  ");
        made += "  m_LockedProperties: \n  m_SavedProperties:\n    serializedVersion: 3\n    m_TexEnvs:\n";
        for (const TextureText& each : textures)
            made += fmt::format("    - {}:\n        m_Texture: {}\n        m_Scale: {}\n        m_Offset: {}\n",
                                each.name, picture(each), each.scale, each.offset);
        made += "    m_Ints: []\n    m_Floats:\n";
        for (const ValueText& each : numbers) made += fmt::format("    - {}: {}\n", each.name, each.value);
        made += "    m_Colors:\n";
        for (const ValueText& each : colors) made += fmt::format("    - {}: {}\n", each.name, each.value);
        return made + "  m_BuildTextureStacks: []\n";
    }

    // As Unity 5.0 to 5.4 wrote it.
    std::string old_text() const {
        std::string made = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!21 &2100000\nMaterial:\n";
        made += fmt::format("  serializedVersion: 6\n  m_Name: x\n  m_Shader: {}\n  m_ShaderKeywords:", shader);
        for (const std::string& each : keywords) made += " " + each;
        made += fmt::format("\n  m_LightmapFlags: 4\n  m_CustomRenderQueue: {}\n  stringTagMap: {{}}\n", queue);
        made += "  m_SavedProperties:\n    serializedVersion: 2\n    m_TexEnvs:\n";
        for (const TextureText& each : textures)
            made += entry(each.name) + fmt::format(
                                           "          m_Texture: {}\n          m_Scale: {}\n"
                                           "          m_Offset: {}\n",
                                           picture(each), each.scale, each.offset);
        made += "    m_Floats:\n";
        for (const ValueText& each : numbers)
            made += fmt::format("      data:\n        first:\n          name: {}\n        second: {}\n", each.name,
                                each.value);
        made += "    m_Colors:\n";
        for (const ValueText& each : colors)
            made += fmt::format("      data:\n        first:\n          name: {}\n        second: {}\n", each.name,
                                each.value);
        return made;
    }

private:
    static std::string list(const std::vector<std::string>& words, const std::string& indent) {
        if (words.empty()) return " []\n";
        std::string made = "\n";
        for (const std::string& each : words) made += indent + "- " + each + "\n";
        return made;
    }
    static std::string entry(const std::string& name) {
        return fmt::format("      data:\n        first:\n          name: {}\n        second:\n", name);
    }
    static std::string picture(const TextureText& each) {
        return each.guid.empty() ? "{fileID: 0}" : fmt::format("{{fileID: 2800000, guid: {}, type: 3}}", each.guid);
    }
};

// A folder of the test's own, empty at first.
class MaterialFolder {
public:
    MaterialFolder() {
        const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) / "unitymaterial" / test->name();
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    // Writes a file, and with a GUID the ".meta" that Unity keeps for it. `settings`: lines of the meta file.
    std::string save(const std::string& name, const std::string& text, const std::string& guid = {},
                     const std::string& settings = {}) const {
        const std::string path = (folder_ / name).string();
        std::ofstream(path, std::ios::binary) << text;
        if (!guid.empty())
            std::ofstream(path + ".meta", std::ios::binary) << "fileFormatVersion: 2\nguid: " << guid << "\n"
                                                            << settings;
        return path;
    }
    std::string path() const { return folder_.string(); }

private:
    std::filesystem::path folder_;
};

// The import settings of a picture.
inline std::string texture_meta(const std::string& mipmaps, const std::string& sampler, const std::string& more = {}) {
    return fmt::format("TextureImporter:\n  serializedVersion: 12\n  mipmaps:\n    {}\n  textureSettings:\n    {}\n{}",
                       mipmaps, sampler, more);
}

}  // namespace patina::importers
