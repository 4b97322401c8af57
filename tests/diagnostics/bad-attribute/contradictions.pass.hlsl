// Passes whose attributes agree with nothing: each is told at the attribute.
struct First {
    [target("color", "rgba8")] float4 color;
    [target("extra", "rgba16f")] float4 extra;
};
struct Second {
    [target("extra", "rgba8")] float4 extra;
};

[pass("volumes")] [pass("screen")] [pass("idle")] [pass("early")] [pass("first")] [pass("second")] [pass("depth")]
[pass("caster")] [vertex]
float4 sharedVertex(float3 position = positionOS) {
    return float4(position.xy, 0, 1);
}

[pass("volumes")] [fragment] [draws("light-volumes")] [lights("all")] [blend("one", "one")]
float4 volumes() { return float4(1); }

[pass("screen")] [fragment] [draws("fullscreen")] [lights("shadowed")] [depthTarget("shadowMap")]
void screen() {}

[pass("idle")] [fragment] [each("light")] [lights("none")]
float4 idle() { return float4(1); }

[pass("early")] [fragment] [lights("none")] [draws("fullscreen")] [stencil("equal", "keep", "lighting")]
float4 early() { return float4(1); }

[pass("first")] [fragment] [lights("none")]
First first() {
    First made;
    made.color = float4(1);
    made.extra = float4(1);
    return made;
}

[pass("second")] [fragment] [lights("none")]
Second second() {
    Second made;
    made.extra = float4(1);
    return made;
}

[pass("depth")] [fragment] [lights("none")] [target("depth", "rgba8")]
float4 depth() { return float4(1); }

[pass("caster")] [fragment] [lights("shadowed")] [each("light")] [depthTarget("shadowMap")]
float4 caster() { return float4(1); }
