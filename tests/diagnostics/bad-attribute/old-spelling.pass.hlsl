[extern("Object")] [per_object] float4x4 moved;

[pass("forward")] [vertex]
float4 mineVertex(float3 position = positionWS) { return mul(worldToClip, float4(position, 1)); }

[pass("forward")] [fragment] [depth_target("depth")]
float4 mineFragment() { return float4(1, 1, 1, 1); }
