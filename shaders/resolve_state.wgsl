// The states of a pixel's draw, whose record is at `draw`.
    //#load sa tp_records draw
    let fragment_uniforms = WORD(sa, 0);
//#if TEXTURES
    let textures = WORD(sa, 1);
    //#insert TEXTURES
//#endif
    var state: TpState;
    //#include state
