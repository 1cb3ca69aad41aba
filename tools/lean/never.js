// What no material, light or picture of www/view3d is given, by the names that the 3D library's renderer has for the thing that
// would have it, with what it is by default. tests/page/shaders.test.mjs sees that no file of www/ gives it.
const MAPS = 'map alphaMap lightMap aoMap bumpMap normalMap displacementMap emissiveMap metalnessMap roughnessMap specularMap envMap matcap gradientMap clearcoatMap clearcoatNormalMap clearcoatRoughnessMap iridescenceMap iridescenceThicknessMap sheenColorMap sheenRoughnessMap specularColorMap specularIntensityMap transmissionMap thicknessMap anisotropyMap diffuseRoughnessMap';
const STRENGTHS = 'anisotropy clearcoat dispersion iridescence sheen transmission retroreflectivity diffuseRoughness alphaTest';
const SWITCHES = 'alphaHash alphaToCoverage dithering premultipliedAlpha wireframe clipShadows clipIntersection stencilWrite flatShading';
const OF_SHADERS = 'retroreflection normalMapObjectSpace normalMapTangentSpace packedNormalMap fog fogExp2 envMapMode envMapPMREM skinning morphTargets morphNormals morphColors batching batchingColor instancingMorph pointsUvs vertexTangents logarithmicDepthBuffer decodeVideoTexture decodeVideoTextureEmissive extensionClipCullDistance extensionMultiDraw sizeAttenuation';
const COUNTS = 'numLightProbes numLightProbeGrids numClippingPlanes numClipIntersection morphTargetsCount numPointLights numSpotLights numRectAreaLights numSunLights numSunLightShadows numSpotLightMaps numPointLightShadows numSpotLightShadows numSpotLightShadowsWithMaps toneMapping';

const words = (/** @type {string} */ text) => text.split(' ');

/** @param {string} names @param {unknown} value */
const all = (names, value) => Object.fromEntries(names.split(' ').map((name) => [name, value]));

/** @type {Record<string, Record<string, unknown>>} */
export const NEVER_SET = {
  material: { ...all(MAPS, null), ...all(STRENGTHS, 0), ...all(SWITCHES, false), clippingPlanes: null },
  parameters: { ...all(`${MAPS} ${STRENGTHS} ${SWITCHES.replace(' flatShading', '')} ${OF_SHADERS}`, false), ...all(MAPS.replaceAll('ap ', 'apUv ').concat('Uv'), false), ...all(COUNTS, 0) },
  scene: { fog: null, environment: null, background: null, overrideMaterial: null },
  object: { customDistanceMaterial: undefined, morphTargetInfluences: undefined, morphTexture: null },
};

/** Shaders of the materials that are used; with `depth` shadows are drawn. */
export const SHADERS = words('basic standard depth shadow');

/** Groups of uniforms that only pictures on materials, fog, points and sprites have. */
export const NO_UNIFORMS = words('specularmap aomap lightmap bumpmap normalmap displacementmap emissivemap gradientmap roughnessmap metalnessmap fog points sprite');

/**
 * Methods of classes that have many, of which those that nothing calls are kept only because other classes have some of the
 * same name: where one is called after all, it is not there, and the call fails.
 * @type {Record<string, string[]>}
 */
export const METHODS = {
  Vector4: words('constructor set copy clone multiplyScalar floor round equals fromArray toArray applyMatrix4 setFromMatrixPosition fromBufferAttribute setScalar addScaledVector'),
  Texture: words('constructor setValues updateMatrix dispose addEventListener removeEventListener dispatchEvent'),
  DepthTexture: words('constructor'),
  RenderTarget: words('constructor setSize dispose _setTextureOptions'),
  Material: words('constructor onBeforeRender onBeforeCompile customProgramCacheKey setValues dispose clone copy'),
};

/**
 * Parts of the library's files, each from a text to another. Shadows are drawn in one of its ways, without a second pass; and
 * whether a program could be made is not asked, which would wait until it is: tests/e2e/shaders.test.mjs asks.
 */
export const LEFT_OUT = [
  ['WebGLShadowMap.js', 'const shadowMaterialVertical = new', 'const scope = this;'],
  ['WebGLProgram.js', '// check for link errors', '// Clean up'],
];
