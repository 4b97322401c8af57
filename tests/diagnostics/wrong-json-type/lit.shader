Shader "Lit" { }
