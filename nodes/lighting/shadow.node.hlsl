// Shadow maps: the share of a light that reaches a point, from the depths that the light sees, and its combination with
// baked shadows.

/// The share of a tent of base width 5 that lies before a place.
///
/// It is the integral of (1 - |t| / 2.5) / 2.5 up to t: 1/2 + v - v |v| / 2, v = t / 2.5 within -1 to 1.
float3 Tent5Share(float3 t) {
    float3 v = clamp(t / 2.5, -1, 1);
    return v * (1 - 0.5 * abs(v)) + 0.5;
}

/// The weights of six texels in a row for a tent filter five texels wide: each is the tent's share over its texel.
///
/// The tent is (1 - |t| / 2.5) / 2.5, t in texels from its peak. The six texels lie around the texel border that is
/// nearest to the peak. The weights add up to 1.
///
/// formula: w_i = S(i - 2 - offset) - S(i - 3 - offset), i = 0 to 5, S the tent's integral:
/// formula: S(t) = 1/2 + v - v |v| / 2, v = t / 2.5 within -1 to 1
/// source: percentage-closer filtering: Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth Maps", SIGGRAPH
/// source: 1987; there the filter is a box
/// test: TentWeights5(0).before == float3(0.02, 0.16, 0.32)
/// test: TentWeights5(0).after == float3(0.32, 0.16, 0.02)
/// test: TentWeights5(0.25).before == float3(0.005, 0.12, 0.28)
/// test: TentWeights5(0.25).after == float3(0.35, 0.2, 0.045)
/// test: TentWeights5(0.5).before == float3(0, 0.08, 0.24)
/// test: TentWeights5(-0.5).before == float3(0.08, 0.24, 0.36)
[node("Lighting/Shadow/Tent Weights")]
void TentWeights5(
    [range(-0.5, 0.5)] float offset = 0,  ///< distance of the tent's peak from the border, in texels
    [range(0, 0.36)] out float3 before,   ///< weights of the three texels before the border, the outermost first
    [range(0, 0.36)] out float3 after     ///< weights of the three texels after it, the outermost last
) {
    float3 lower = Tent5Share(float3(-2, -1, 0) - offset);
    float3 upper = Tent5Share(float3(1, 2, 3) - offset);
    before = lower - float3(0, lower.xy);
    after = upper - float3(lower.z, upper.xy);
}

/// The share of a light that arrives: percentage-closer filtering of its shadow map with a tent five texels wide.
///
/// The depth is compared with each of 6 x 6 texels, which are read one by one at their centres, and the results are
/// weighted. Outside the map and beyond its far plane, everything is lit.
///
/// formula: sum over i, j of w_i(x) w_j(y) [depth <= map_ij], the weights those of TentWeights5
/// source: Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth Maps", SIGGRAPH 1987
[node("Lighting/Shadow/Sample Tent 5x5")] [range(0, 1)]
float SampleShadowTent5x5(
    Texture2D map,                    ///< red: depth of the first surface that the light sees, 0 near to 1 far
    float2 uv,                        ///< place in the map, 0 to 1 from the top left
    [range(0, 1)] float depth,        ///< depth of the lit point, minus its bias
    float texel,                      ///< 1 / size of the whole texture in texels, which is square
    float4 tile = float4(1, 1, 0, 0)  ///< which part of the texture the map is: size (xy) and upper left corner (zw)
) {
    float2 peak = (uv * tile.xy + tile.zw) / texel;
    float2 border = floor(peak + 0.5);
    float2 offset = peak - border;
    // The centres of the map's outermost texels, so that a neighbouring map is never read.
    float2 first = tile.zw + 0.5 * texel;
    float2 last = tile.zw + tile.xy - 0.5 * texel;
    float3 left = clamp((border.x + float3(-2.5, -1.5, -0.5)) * texel, first.x, last.x);
    float3 right = clamp((border.x + float3(0.5, 1.5, 2.5)) * texel, first.x, last.x);
    float3 leftWeights = TentWeights5(offset.x).before;
    float3 rightWeights = TentWeights5(offset.x).after;
    float lit = 0;
    for (int row = 0; row < 6; row++) {
        float upperEdge = float(row) - 3;
        float v = clamp((border.y + upperEdge + 0.5) * texel, first.y, last.y);
        float3 leftDepths = float3(map.SampleLevel(float2(left.x, v), 0).r, map.SampleLevel(float2(left.y, v), 0).r,
                                    map.SampleLevel(float2(left.z, v), 0).r);
        float3 rightDepths = float3(map.SampleLevel(float2(right.x, v), 0).r, map.SampleLevel(float2(right.y, v), 0).r,
                                     map.SampleLevel(float2(right.z, v), 0).r);
        float ofRow = dot(leftWeights, step(depth, leftDepths)) + dot(rightWeights, step(depth, rightDepths));
        float2 shares = Tent5Share(float3(upperEdge, upperEdge + 1, 0) - offset.y).xy;
        lit += (shares.y - shares.x) * ofRow;
    }
    float2 fromMiddle = abs(uv - 0.5);
    return max(fromMiddle.x, fromMiddle.y) <= 0.5 && depth <= 1 ? lit : 1;
}

/// Moves a surface inwards when it is drawn into a shadow map, so that it does not shadow itself: the more, the more
/// the light grazes it.
///
/// formula: position - bias sqrt(1 - (n.l)^2) n
/// source: Holbert, "Saying Goodbye to Shadow Acne", GDC 2011; Unity built-in shaders, UnityClipSpaceShadowCasterPos
/// test: ShadowNormalBias(float3(1, 2, 3), float3(0, 0, 1), float3(0.6, 0, 0.8), 0.5) == float3(1, 2, 2.7)
/// test: ShadowNormalBias(float3(1, 2, 3), float3(0, 0, 1), float3(0, 0, 1), 0.5) == float3(1, 2, 3)
/// test: ShadowNormalBias(float3(1, 2, 3), float3(0, 1, 0), float3(-0.8, -0.6, 0), 0.25) == float3(1, 1.8, 3)
[node("Lighting/Shadow/Normal Bias")]
float3 ShadowNormalBias(
    [unit("m")] float3 position = positionWS,   ///< point of the surface
    float3 normal = normalWS,                   ///< unit normal
    float3 lightDir = light.direction,          ///< unit direction to the light
    [range(0, 1)] [unit("m")] float bias = 0.01  ///< distance inwards where the light grazes the surface
) {
    float cosine = dot(normal, lightDir);
    return position - normal * (bias * sqrt(max(1 - cosine * cosine, 0)));
}

/// How far real-time shadows have faded out: 0 near the camera, 1 where shadows have ended.
///
/// formula: saturate(distance scale + offset)
/// source: Unity built-in shaders, UnityComputeShadowFade
/// test: ShadowFade(45, 0.1, -4) == 0.5
/// test: ShadowFade(30, 0.1, -4) == 0
/// test: ShadowFade(60, 0.1, -4) == 1
[node("Lighting/Shadow/Fade")] [range(0, 1)]
float ShadowFade(
    [range(0, 1000)] [unit("m")] float distance,  ///< from the camera
    [range(0, 100)] float scale = 0.1,            ///< 1 / length of the fade in metres
    [range(-1000, 1)] float offset = -4           ///< minus the distance where the fade begins, times scale
) {
    return saturate(distance * scale + offset);
}

/// The shadow of one light in a shadow mask: each channel holds the shadow of one light.
///
/// formula: saturate(dot(mask, selector))
/// source: Unity built-in shaders, UnitySampleBakedOcclusion
/// test: ShadowMaskChannel(float4(0.1, 0.4, 0.6, 0.9), float4(0, 0, 1, 0)) == 0.6
/// test: ShadowMaskChannel(float4(0.1, 0.4, 0.6, 0.9), float4(1, 0, 0, 1)) == 1
/// test: ShadowMaskChannel(float4(0.1, 0.4, 0.6, 0.9), 0) == 0
[node("Lighting/Shadow/Mask Channel")] [range(0, 1)]
float ShadowMaskChannel(
    [range(0, 1)] float4 mask = 1,        ///< the texel: 1 lit, 0 in shadow
    float4 selector = float4(1, 0, 0, 0)  ///< 1 in the light's channel, 0 in the others
) {
    return saturate(dot(mask, selector));
}

/// How baked shadows combine with the real-time shadows of moving objects.
enum ShadowMixing {
    Shadowmask,          ///< both apply; only baked shadows reach far
    DistanceShadowmask,  ///< real-time shadows near the camera, baked ones where they have faded
    RealtimeOnly         ///< there are no baked shadows
};

/// Combines the real-time and baked shadows of one light.
///
/// formula: Shadowmask: min(saturate(realtime + fade), baked); DistanceShadowmask: lerp(realtime, baked, fade);
/// formula: RealtimeOnly: saturate(realtime + fade)
/// source: Unity built-in shaders, UnityMixRealtimeAndBakedShadows
/// test: MixRealtimeAndBakedShadow(0.25, 0.75, 0.25) == 0.5
/// test: MixRealtimeAndBakedShadow(0.25, 0.75, 1) == 0.75
/// test: MixRealtimeAndBakedShadow(0.25, 0.75, 0.25, DistanceShadowmask) == 0.375
/// test: MixRealtimeAndBakedShadow(0.25, 0.75, 0.25, RealtimeOnly) == 0.5
/// test: MixRealtimeAndBakedShadow(0.25, 0.75, 1, RealtimeOnly) == 1
[node("Lighting/Shadow/Mix Realtime and Baked")] [range(0, 1)]
float MixRealtimeAndBakedShadow(
    [range(0, 1)] float realtime = 1,       ///< from the shadow map: 1 lit, 0 in shadow
    [range(0, 1)] float baked = 1,          ///< from the shadow mask
    [range(0, 1)] float fade = 0,           ///< how far real-time shadows have faded: 1 where they have ended
    const ShadowMixing mixing = Shadowmask  ///< how they combine
) {
    if (mixing == DistanceShadowmask) { return lerp(realtime, baked, fade); }
    if (mixing == RealtimeOnly) { return saturate(realtime + fade); }
    return min(saturate(realtime + fade), baked);
}
