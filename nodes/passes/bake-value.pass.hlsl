// One value as a texture: what an unlit surface emits, drawn where the texture coordinates of the mesh are. `patina
// bake` draws the inputs of glTF's layers with it, one after the other, each as the colour of an unlit surface.

struct BakedValue {
    [target("bakedValue", "rgba32f")] float4 value;  // 1 in alpha where the mesh is
};

[pass("bake-value")] [fragment] [lights("all")] [blend("one", "zero")] [depth("always", "keep")]
[lacks("fragCoord", "screenSize", "color", "depth")]
[lacks("time", "fixedTime")] [lacks("Camera", "fixedView")]
[lacks("Lights", "Shadows", "Ambient", "environmentMap", "lightCookie", "fixedLight")]
BakedValue bakeValueFragment() {
    LightingSurface lit = lightingSurface();
    BakedValue baked;
    baked.value = float4(lit.emission, 1);
    return baked;
}
