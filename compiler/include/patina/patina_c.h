// The compiler for programs in C, and in any language that can call C. It has the part of patina.h that most programs
// need: a graph in, shaders and their reflection out.
//
//   patina_compiler* compiler = NULL;
//   if (patina_compiler_create(PATINA_C_ABI, NULL, 0, &compiler) != PATINA_OK) return 1;
//   patina_result* result = NULL;
//   if (patina_compile_file(compiler, "rust.graph.json", "{ \"targets\": [\"glsl\"] }", NULL, &result) == PATINA_OK) {
//       fputs(patina_result_messages(result), stderr);
//       for (size_t i = 0; i < patina_result_shader_count(result); i++) save(patina_result_shader(result, i));
//   }
//   patina_result_free(result);
//   patina_compiler_free(compiler);
//
// Texts are UTF-8. Texts that the library returns end with a zero byte and live as long as their object. Texts that a
// program passes are copied, or only read during the call. No function throws, and no function ends the program. If an
// object is required and the pointer is null, the status is PATINA_BAD_ARGUMENT, or the result is empty. The same is
// true for an impossible size: of a text that is null and not empty, or more than PTRDIFF_MAX bytes. After any status,
// all objects are as usable as before.
//
// Threads: any number of them may compile with one compiler, and read one result. An object is freed once, when no
// other thread uses it.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "patina/export.h"
#include "patina/version.h"

#ifdef __cplusplus
extern "C" {
#endif

// Grows with each change of this header with which older programs cannot run.
#define PATINA_C_ABI 1

// The compiler with its library. It is loaded once, and never changes.
typedef struct patina_compiler patina_compiler;
// The result of a compilation. It is complete and never changes.
typedef struct patina_result patina_result;
// The answer of a callback. It may be used only during the call.
typedef struct patina_reply patina_reply;

// The status of a call.
typedef enum patina_status {
    PATINA_OK = 0,             // all is well
    PATINA_HAS_ERRORS = 1,     // errors in the graph, the options or a file: see the messages
    PATINA_WRONG_ABI = 2,      // the program was compiled for another version of this header
    PATINA_BAD_ARGUMENT = 3,   // a required pointer is null, or a size or a word is impossible
    PATINA_OUT_OF_MEMORY = 4,  // there was not enough memory; no object was made
    PATINA_INTERNAL_ERROR = 5  // a bug in the library; no object was made
} patina_status;

// The status as a sentence, for messages. It lives as long as the program.
PATINA_API const char* patina_status_text(patina_status status);

// PATINA_C_ABI of the library that runs.
PATINA_API uint32_t patina_c_abi(void);
// The version of the library that runs: "0.1.0". It lives as long as the program.
PATINA_API const char* patina_version(void);

// --- the compiler

// A file that a program adds to the library: a node, a rendering path, a lighting model or a workflow.
typedef struct patina_library_file {
    const char* name;  // its ending decides the kind: "mine/dots.node.hlsl" (LibraryFile in patina/patina.h)
    const char* text;  // need not end with a zero byte
    size_t size;       // bytes of the text
} patina_library_file;

// Makes a compiler. `abi` is PATINA_C_ABI. `files` may be null if `count` is 0; errors in them are in the messages of
// each result.
PATINA_API patina_status patina_compiler_create(uint32_t abi, const patina_library_file* files, size_t count,
                                                patina_compiler** compiler);
// Frees a compiler. Its results may live on. Null is allowed.
PATINA_API void patina_compiler_free(patina_compiler* compiler);

// --- files of the program's own

// Where a compilation finds files. Each function may be null, and is called from the thread that compiles. A function
// must not leave the call by longjmp. A C++ function may throw: the compilation then has an error with what() as its
// reason.
typedef struct patina_callbacks {
    void* user;  // handed to each function
    // Returns the text of a file: calls patina_reply_text() with the text, patina_reply_error() if the file cannot be
    // read, and neither if there is no file. Within one compilation it is called once for each file. Null: the disk.
    void (*read)(void* user, const char* path, patina_reply* reply);
    // Not 0 if the file exists. For textures, only this function is called. Null: a file exists if `read` returns a
    // text.
    int (*exists)(void* user, const char* path);
    // Returns the path of the file that `name` means in the file `from`, by patina_reply_text(). If it calls nothing,
    // the name is the path. Null: paths and URIs are joined as usual.
    void (*resolve)(void* user, const char* from, const char* name, patina_reply* reply);
    // Not 0: the compilation ends with the error `cancelled`. It is called often. Null: never cancelled.
    int (*cancelled)(void* user);
} patina_callbacks;

// Answers with a text, which is copied. It need not end with a zero byte. If the size is impossible, the file counts as
// one that cannot be read.
PATINA_API void patina_reply_text(patina_reply* reply, const char* text, size_t size);
// Answers that the file exists and cannot be read, with the reason: the error `cannot-read` at the location that names
// the file.
PATINA_API void patina_reply_error(patina_reply* reply, const char* reason);

// --- compilation

// Compiles a graph from a text. `path` names it in messages and in names of shaders; files that it names are searched
// from there.
//
// `options` is a JSON object, or null. All keys may be left out:
//
//   "targets"       list of languages and engines: "glsl", "hlsl", "unity"; without it GLSL and HLSL. An
//                   empty list: the graph is checked, and nothing is written
//   "path"          the rendering path: "forward", "deferred", a file
//   "passes"        list of passes, instead of all of the path
//   "preview"       a port that is shown instead of the surface: "mask.r", "surface.roughness"
//   "functions"     a prefix: functions for shaders of your own instead of passes
//   "switches"      object: values of switches, variants and specialization constants
//   "lighting"      a lighting model instead of the graph's own
//   "includeDirs"   list of folders that are searched after the graph's own
//   "root"          a folder of the disk: nothing outside of it is read, whatever a graph names
//   "keepVariants"  true: the shaders keep all values of variants that "switches" leaves open
//   "acceptParts"   true: also compiles a lighting graph or a sub-graph
//   "hashes"        true: the reflection has the hash of each pass
//   "limits"        object: the most "nodes", "instructions", "sourceBytes" and "shaderBytes"
//
// patina::CompileOptions says more about each. An error in the text has a location in a file with the name "options".
// An error in a name that depends on the graph or the path, such as one of "switches", has no location.
//
// `callbacks` may be null. A result is made if the status is PATINA_OK or PATINA_HAS_ERRORS; otherwise it is null.
PATINA_API patina_status patina_compile(const patina_compiler* compiler, const char* path, const char* text,
                                        size_t size, const char* options, const patina_callbacks* callbacks,
                                        patina_result** result);
// The same, with the text of the file that `path` names.
PATINA_API patina_status patina_compile_file(const patina_compiler* compiler, const char* path, const char* options,
                                             const patina_callbacks* callbacks, patina_result** result);
// Room for a key, with its zero byte.
#define PATINA_KEY_SIZE 33
// Writes a key to `key`, which has room for PATINA_KEY_SIZE bytes: two compilations with one key give one result.
// `text` is null, and `size` 0, for the text of the file that `path` names. The function reads the graph and the files
// that the graph names, and compiles nothing. A graph with errors has a key, too. PATINA_HAS_ERRORS: the options are
// wrong, and the key is empty.
PATINA_API patina_status patina_cache_key(const patina_compiler* compiler, const char* path, const char* text,
                                          size_t size, const char* options, const patina_callbacks* callbacks,
                                          char* key);
// Writes a key of the library with the added files, and of this build of the compiler.
PATINA_API patina_status patina_library_hash(const patina_compiler* compiler, char* key);
// Frees a result with everything that it has returned. Null is allowed.
PATINA_API void patina_result_free(patina_result* result);

// --- results

// Errors and warnings for people: with the line, a caret and notes. Empty if there are none.
PATINA_API const char* patina_result_messages(const patina_result* result);
// The same for programs: a JSON array (empty if there are none) of what `patina check --diagnostics=json` prints.
PATINA_API const char* patina_result_diagnostics(const patina_result* result);

// A shader: a stage of a pass, or a file that holds all passes.
typedef struct patina_shader {
    const char* file_name;  // "rust.forward.frag.glsl"
    const char* text;       // ends with a zero byte
    size_t size;            // bytes of the text, without that zero
    const char* pass;       // "forward"; empty: a file that holds all passes, or functions
    const char* stage;      // "vertex", "fragment"
    const char* engine;     // empty: the default engine
    const char* language;   // "glsl"
} patina_shader;

// The number of shaders; 0 if there are errors.
PATINA_API size_t patina_result_shader_count(const patina_result* result);
// One of the shaders, which lives as long as the result; null if there is no such shader.
PATINA_API const patina_shader* patina_result_shader(const patina_result* result, size_t index);
// The reflection as JSON, as NAME.reflect.json has it; empty if there are errors.
PATINA_API const char* patina_result_reflection(const patina_result* result);
// The number of files that were read, the graph first: they are what the result depends on.
PATINA_API size_t patina_result_dependency_count(const patina_result* result);
// The path of one of them; null if there is no such file.
PATINA_API const char* patina_result_dependency(const patina_result* result, size_t index);
// The number of files that were searched for and do not exist, sorted. For example, a file is searched in the folder of
// the graph before "includeDirs". If one of these files appears, the result may change.
PATINA_API size_t patina_result_missing_count(const patina_result* result);
// The path of one of them; null if there is no such file.
PATINA_API const char* patina_result_missing(const patina_result* result, size_t index);

// --- variants

// The combinations of a material's variants, before they are compiled.
typedef struct patina_plan patina_plan;
// The programs of the combinations. Combinations with equal shaders share one program.
typedef struct patina_variants patina_variants;
// The usual limit of their number.
#define PATINA_VARIANT_LIMIT 1024

// Counts the combinations, and compiles only as much as that needs. `wanted` is "all"; "listed": those under the
// graph's "variants"; or "reachable": without choices that change nothing. Another word is PATINA_BAD_ARGUMENT. More
// than `limit` combinations are an error. `options` and `callbacks` are as for patina_compile(); the plan keeps both,
// and the callbacks may be called as long as it lives. A plan is made if the status is PATINA_OK or PATINA_HAS_ERRORS.
PATINA_API patina_status patina_plan_variants(const patina_compiler* compiler, const char* path, const char* wanted,
                                              size_t limit, const char* options, const patina_callbacks* callbacks,
                                              patina_plan** plan);
// The number of combinations; 0 if there are errors.
PATINA_API size_t patina_plan_count(const patina_plan* plan);
// A combination as a JSON object, { "_Mode": "Wet" }; null if there is none of this index.
PATINA_API const char* patina_plan_combination(const patina_plan* plan, size_t index);
// The variants as a JSON array, in the order of the graph: "property", its "values", and its "default".
PATINA_API const char* patina_plan_axes(const patina_plan* plan);
// As for a result.
PATINA_API const char* patina_plan_messages(const patina_plan* plan);
PATINA_API const char* patina_plan_diagnostics(const patina_plan* plan);  // the same
// Frees a plan. Programs that were compiled from it may live on. Null is allowed.
PATINA_API void patina_plan_free(patina_plan* plan);

// Compiles all combinations of a plan, with the compiler that made the plan.
PATINA_API patina_status patina_compile_variants(const patina_compiler* compiler, const patina_plan* plan,
                                                 patina_variants** variants);
// The number of different programs; 0 if there are errors.
PATINA_API size_t patina_variants_program_count(const patina_variants* variants);
// The shaders and the reflection of a program. It lives as long as `variants` and is not freed; null if there is none
// of this index. Messages, dependencies and missing files are not in it: `variants` has those of all combinations.
PATINA_API const patina_result* patina_variants_program(const patina_variants* variants, size_t index);
// The hash of a program: 32 hexadecimal digits; null if there is none of this index.
PATINA_API const char* patina_variants_hash(const patina_variants* variants, size_t index);
// The index of the program that a combination of the plan runs; (size_t)-1 if there is no such combination.
PATINA_API size_t patina_variants_program_of(const patina_variants* variants, size_t combination);
// As for a result.
PATINA_API const char* patina_variants_messages(const patina_variants* variants);
PATINA_API const char* patina_variants_diagnostics(const patina_variants* variants);               // the same
PATINA_API size_t patina_variants_dependency_count(const patina_variants* variants);               // the same
PATINA_API const char* patina_variants_dependency(const patina_variants* variants, size_t index);  // the same
PATINA_API size_t patina_variants_missing_count(const patina_variants* variants);                  // the same
PATINA_API const char* patina_variants_missing(const patina_variants* variants, size_t index);     // the same
// Frees all of it. Null is allowed.
PATINA_API void patina_variants_free(patina_variants* variants);

// --- scenes

// A scene that was read. It is complete and never changes.
typedef struct patina_scene patina_scene;

// Reads a scene; its graphs are found, not compiled. Of the options only "includeDirs", "root" and "limits" count. A
// scene is made if the status is PATINA_OK or PATINA_HAS_ERRORS.
PATINA_API patina_status patina_read_scene(const patina_compiler* compiler, const char* path, const char* options,
                                           const patina_callbacks* callbacks, patina_scene** scene);
// The scene as JSON: the keys and words of scene files, with the defaults filled in, colours as linear numbers, files
// as paths that can be opened, and the values of "set" as texts: "0.2", "1,0,0", "Wet". Empty if there are errors.
PATINA_API const char* patina_scene_json(const patina_scene* scene);
// The number of its materials; 0 if there are errors.
PATINA_API size_t patina_scene_material_count(const patina_scene* scene);
// The path of a material's graph, for patina_compile_file(); null if there is none of this index.
PATINA_API const char* patina_scene_graph(const patina_scene* scene, size_t material);
// As for a result.
PATINA_API const char* patina_scene_messages(const patina_scene* scene);
PATINA_API const char* patina_scene_diagnostics(const patina_scene* scene);               // the same
PATINA_API size_t patina_scene_dependency_count(const patina_scene* scene);               // the same
PATINA_API const char* patina_scene_dependency(const patina_scene* scene, size_t index);  // the same
PATINA_API size_t patina_scene_missing_count(const patina_scene* scene);                  // the same
PATINA_API const char* patina_scene_missing(const patina_scene* scene, size_t index);     // the same
// Frees a scene. Null is allowed.
PATINA_API void patina_scene_free(patina_scene* scene);

// --- the library

// A node.
typedef struct patina_node {
    const char* name;      // as "node" of a graph names it
    const char* category;  // "Lighting/Distribution"
    const char* doc;       // paragraphs, plain text
    const char* file;      // where it is defined
    const char* json;      // all of it, with its ports, as an object: NodeInfo in patina/patina.h
} patina_node;
// A rendering path.
typedef struct patina_path {
    const char* name;  // as "path" of the options names it
    const char* doc;   // paragraphs, plain text
    const char* file;  // where it is defined
    const char* json;  // all of it, with its passes, as an object: PathInfo
} patina_path;
// An engine.
typedef struct patina_engine {
    const char* name;   // as "targets" of the options name it
    const char* title;  // "Vulkan"
    const char* doc;    // a sentence about its files
    const char* json;   // all of it, with its languages and paths, as an object: EngineInfo
} patina_engine;

// Returns the list of all nodes, by category, then name. The list lives as long as the compiler and must not be freed.
PATINA_API patina_status patina_nodes(const patina_compiler* compiler, const patina_node** nodes, size_t* count);
// The same for the rendering paths, by name.
PATINA_API patina_status patina_paths(const patina_compiler* compiler, const patina_path** paths, size_t* count);
// The same for the engines, the default one first.
PATINA_API patina_status patina_engines(const patina_compiler* compiler, const patina_engine** engines, size_t* count);

#ifdef __cplusplus
}  // extern "C"
#endif
