// Compiles a graph from a string and prints the GLSL, as examples/embed does in C++. The graph's own node is a file that
// only this program knows.
#include <patina/patina_c.h>

#include <stdio.h>
#include <string.h>

static const char graph[] =
    "{\n"
    "  \"patina\": 1,\n"
    "  \"workflow\": \"metallic-roughness\",\n"
    "  \"lighting\": \"unity-brdf1\",\n"
    "  \"properties\": [{ \"name\": \"_Tint\", \"type\": \"color\", \"default\": \"#c9a27e\" }],\n"
    "  \"nodes\": [{ \"id\": \"dots\", \"node\": \"./dots.node.hlsl\", \"in\": { \"scale\": 8 } }],\n"
    "  \"surface\": { \"baseColor\": \"= $_Tint.rgb * (0.5 + 0.5 * dots)\", \"roughness\": 0.4 }\n"
    "}\n";

static const char dots[] =
    "/// Round dots, a grid of them.\n"
    "[node(\"Procedural/Dots\")]\n"
    "float Dots(float2 uv = uv0, float scale = 4) {\n"
    "    float2 cell = frac(uv * scale) - 0.5;\n"
    "    return smoothstep(0.35, 0.3, length(cell));\n"
    "}\n";

static void read_file(void* user, const char* path, patina_reply* reply) {
    (void)user;
    if (strcmp(path, "dots.node.hlsl") == 0) patina_reply_text(reply, dots, strlen(dots));
}

int main(void) {
    patina_compiler* compiler = NULL;  // loads the node library; keep it
    patina_status status = patina_compiler_create(PATINA_C_ABI, NULL, 0, &compiler);
    if (status != PATINA_OK) return fprintf(stderr, "%s\n", patina_status_text(status)), 1;

    const patina_callbacks callbacks = {.read = read_file};
    patina_result* result = NULL;
    status = patina_compile(compiler, "dotted.graph.json", graph, strlen(graph), "{ \"targets\": [\"glsl\"] }", &callbacks,
                            &result);
    fputs(patina_result_messages(result), stderr);
    for (size_t i = 0; i < patina_result_shader_count(result); i++) {
        const patina_shader* shader = patina_result_shader(result, i);
        printf("// ---- %s\n%s\n", shader->file_name, shader->text);
    }
    patina_result_free(result);
    patina_compiler_free(compiler);
    return status == PATINA_OK ? 0 : 1;
}
