//! What the vec4 of a fixed-function program's uniform block mean.

/// A vec4 of a uniform block. Matrices take a slot a column; faces are 0 front, 1 back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slot {
    /// Column of projection * model-view.
    Mvp(u8),
    /// Column of the model-view matrix.
    ModelView(u8),
    /// Row of the inverse of the model-view matrix's upper 3 x 3: the normal transform's columns. w of row 0: the rescale factor.
    NormalRow(u8),
    /// Emission + model ambient * material ambient of a face (the terms that colour material does not replace), w: diffuse alpha.
    SceneColor(u8),
    /// Light model ambient.
    ModelAmbient,
    /// Emission of a face.
    Emission(u8),
    /// Ambient colour of a face's material.
    MaterialAmbient(u8),
    /// Light's ambient colour, times the face's material.
    AmbientProduct(u8, u8),
    /// Light's diffuse colour, times the face's material.
    DiffuseProduct(u8, u8),
    /// Light's specular colour, times the face's material.
    SpecularProduct(u8, u8),
    /// Light's ambient colour.
    LightAmbient(u8),
    /// Light's diffuse colour.
    LightDiffuse(u8),
    /// Light's specular colour.
    LightSpecular(u8),
    /// Eye position of a light (divided by w), or the unit vector towards a directional one.
    LightPosition(u8),
    /// Half vector of a directional light with an infinite viewer.
    LightHalf(u8),
    /// Attenuation: constant, linear, quadratic.
    LightAttenuation(u8),
    /// Unit spot direction, w: cosine of the cutoff.
    LightSpot(u8),
    /// x: spot exponent.
    LightExponent(u8),
    /// x: shininess of a face.
    Shininess(u8),
    /// Column of a unit's texture matrix.
    TextureMatrix(u8, u8),
    /// Object plane of a unit's coordinate.
    ObjectPlane(u8, u8),
    /// Eye plane of a unit's coordinate.
    EyePlane(u8, u8),
    /// The n-th enabled user clip plane.
    ClipPlane(u8),
    /// Point size, minimum, maximum.
    PointSize,
    /// Distance attenuation of points.
    PointAttenuation,
    /// Fog colour.
    FogColor,
    /// Linear: scale and offset of the coordinate. EXP: -density / ln 2. EXP2: density / sqrt(ln 2).
    FogParameters,
    /// Texture environment colour of a unit.
    EnvColor(u8),
}
