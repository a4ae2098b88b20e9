//! Compressed images (3.8.3). No specific compressed format is supported (GL_NUM_COMPRESSED_TEXTURE_FORMATS is 0), which the
//! specification allows: generic ones are stored uncompressed, and all that is left here are errors.

use super::Context;
use super::enums::*;

impl Context {
    /// glCompressedTexImage1D, 2D, 3D: no internal format is one of ours.
    pub fn compressed_tex_image(&mut self) {
        if self.compile(|cx| cx.compressed_tex_image()) || self.inside_begin_end() {
            return;
        }
        self.set_error(GL_INVALID_ENUM, "glCompressedTexImage: no compressed format is supported");
    }

    /// glCompressedTexSubImage1D, 2D, 3D: no image has a compressed format that could match.
    pub fn compressed_tex_sub_image(&mut self) {
        if self.compile(|cx| cx.compressed_tex_sub_image()) || self.inside_begin_end() {
            return;
        }
        self.set_error(GL_INVALID_OPERATION, "glCompressedTexSubImage: no image is compressed");
    }

    /// glGetCompressedTexImage: no image is compressed.
    pub fn get_compressed_tex_image(&mut self) {
        if !self.inside_begin_end() {
            self.set_error(GL_INVALID_OPERATION, "glGetCompressedTexImage: no image is compressed");
        }
    }
}
