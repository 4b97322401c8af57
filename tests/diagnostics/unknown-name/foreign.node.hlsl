[node("Mine/Foreign")]
float Foreign() {
    bvec2 both = false;
    return sin(_Time.y) * M_PI;
}
