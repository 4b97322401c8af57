// What a pass may call: the functions that the graph provides. Their parameters are semantics of the lighting graph;
// a body is what happens when the lighting graph leaves that output out.

/// The surface that the material and its workflow make of this point.
[slot]
LightingSurface lightingSurface();

/// What one light adds, as the lighting graph says.
[slot]
float3 direct(LightingSurface surface, [perLight] Light light);

/// What all light adds that comes from no single light, as the lighting graph says.
[slot]
float3 indirect(LightingSurface surface) {
    return float3(0);
}

/// The lighting graph's last word.
[slot]
float3 final(LightingSurface surface, LightSum sum) {
    return sum.direct + sum.indirect + surface.emission;
}

/// What one light adds to the picture: the part of `final` that is linear in sum.direct. Only that member is read.
[slot] [part("final", "sum.direct")]
float3 added(LightingSurface surface, LightSum sum);

/// `added`, of the light that is alone in the list.
[inline]
float3 addedByLight(LightingSurface surface, float3 position) {
    float3 fromLight = direct(surface, lightAt(0, position));
    LightSum one;
    one.direct = fromLight;
    return added(surface, one);
}

/// `final` over all lights of the list.
[inline]
float3 litByAll(LightingSurface surface, float3 position) {
    float3 directSum = float3(0);
    [light] for (int i = 0; i < min(lightCount, MAX_LIGHTS); i++) {
        directSum += direct(surface, lightAt(i, position));
    }
    LightSum total;
    total.direct = directSum;
    total.indirect = indirect(surface);
    return final(surface, total);
}
