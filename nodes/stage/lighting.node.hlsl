// The functions that the graph provides and a pass may call. Their parameters are semantics of the lighting graph. If
// the lighting graph omits an output, the body here is used.

/// The surface at this point, from the material and its workflow.
[slot]
LightingSurface lightingSurface();

/// The light that one light adds, by the lighting graph.
[slot]
float3 direct(LightingSurface surface, [perLight] Light light);

/// All light that does not come from a single light, by the lighting graph.
[slot]
float3 indirect(LightingSurface surface) {
    return float3(0);
}

/// The final colour, by the lighting graph.
[slot]
float3 final(LightingSurface surface, LightSum sum) {
    return sum.direct + sum.indirect + surface.emission;
}

/// The colour that one light adds: the part of `final` that is linear in sum.direct. Only that member is read.
[slot] [part("final", "sum.direct")]
float3 added(LightingSurface surface, LightSum sum);

/// `added` for the only light of the list.
[inline]
float3 addedByLight(LightingSurface surface, float3 position) {
    float3 fromLight = direct(surface, lightAt(0, position));
    LightSum one;
    one.direct = fromLight;
    return added(surface, one);
}

/// `final` for all lights of the list.
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
