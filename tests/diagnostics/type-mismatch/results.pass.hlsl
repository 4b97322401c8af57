struct Stored {
    [target("first", "rgba8")] float4 first;
    [target("second", "rgba8")] int second;
    [target("third", "rgba8")] float4 third[2];
};

[pass("mine")] [vertex]
float3 mine_vertex(float3 position = position_ws) {
    return position;
}
[pass("mine")] [fragment]
Stored mine_fragment(float3 position = position_ws) {
    Stored made; return made;
}

[pass("other")] [vertex]
float4 other_vertex(float3 position = position_ws) {
    return float4(position, 1);
}
[pass("other")] [fragment]
bool other_fragment() {
    return true;
}
[semantic("vertex")]
Light sun(float3 position = position_ws) {
    return light_at(0, position);
}
[gives("position_ws", "mine")]
float height() {
    return 1;
}
[builtin("front_facing")] float side;
