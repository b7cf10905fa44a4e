// Shaders of the viewer. All move the vertices by `scale` times their displacement, so that the slider of the
// deformation costs nothing per vertex, and cut off what lies behind the section plane of the undeformed part.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const moved = `
    attribute vec3 displacement;
    uniform float scale;
    varying vec3 place;
    vec4 movedView() {
      place = position;
      return modelViewMatrix * vec4(position + scale * displacement, 1.0);
    }`;
  const cut = `
    uniform vec4 plane;
    varying vec3 place;
    void cutBehindPlane() {
      if (dot(plane.xyz, place) > plane.w) discard;
    }`;
  const light = `
    float lightOn(vec3 normal, vec3 view) {
      vec3 n = dot(normal, view) > 0.0 ? -normal : normal;
      return 0.55 + 0.35 * max(dot(n, normalize(vec3(0.25, 0.45, 1.0))), 0.0)
                  + 0.15 * max(dot(n, vec3(0.0, 0.0, 1.0)), 0.0);
    }`;

  const colourOf = `
    uniform sampler2D colours;
    uniform vec2 range;
    uniform float bands;
    uniform float categories;
    uniform vec3 noValue;
    vec3 colourOf(float x) {
      if (!(x < 1e30)) return noValue;
      if (categories > 0.0)
        return texture2D(colours, vec2((mod(floor(x + 0.5), categories) + 0.5) / categories, 0.5)).rgb;
      float t = clamp((x - range.x) / (range.y - range.x), 0.0, 1.0);
      if (bands > 0.0) t = (min(floor(t * bands), bands - 1.0) + 0.5) / bands;
      return texture2D(colours, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    }`;

  const surfaceVertex = moved + `
    attribute float value;
    attribute vec3 normal0;
    attribute vec3 normal1;
    attribute vec3 normal2;
    varying float shade;
    varying vec3 bent;
    varying vec3 view;
    void main() {
      vec4 at = movedView();
      view = at.xyz;
      shade = value;
      bent = normalMatrix * (normal0 + scale * (normal1 + scale * normal2));
      gl_Position = projectionMatrix * at;
    }`;
  // Without normals (sections, collapsed edges) the screen's derivatives give those of the triangle.
  const surfaceFragment = cut + light + colourOf + `
    uniform float opacity;
    varying float shade;
    varying vec3 bent;
    varying vec3 view;
    void main() {
      cutBehindPlane();
      vec3 normal = length(bent) > 1e-4 ? normalize(bent) : normalize(cross(dFdx(view), dFdy(view)));
      gl_FragColor = vec4(colourOf(shade) * lightOn(normal, view), opacity);
    }`;

  // Lines are drawn a little towards the viewer, so that the faces they lie on do not swallow them, and light on dark
  // colours. Plain ones, of a surface that is seen through, have the colour of the page's text.
  const lineVertex = moved + `
    attribute float value;
    varying float shade;
    void main() {
      shade = value;
      vec4 at = movedView();
      gl_Position = projectionMatrix * vec4(0.9985 * at.xyz, 1.0);
    }`;
  const lineFragment = cut + colourOf + `
    uniform float opacity;
    uniform vec3 ink;
    uniform float isPlain;
    varying float shade;
    void main() {
      cutBehindPlane();
      float brightness = dot(colourOf(shade), vec3(0.3, 0.6, 0.1));
      vec3 contrast = brightness < 0.2 ? vec3(0.62) : vec3(0.06);
      gl_FragColor = vec4(isPlain > 0.5 ? ink : contrast, opacity);
    }`;

  // Cones and arrows keep their shape: only the point they stand on moves.
  const symbolVertex = moved + `
    attribute vec3 offset;
    attribute vec3 outward;
    varying vec3 bent;
    varying vec3 view;
    void main() {
      vec4 at = movedView() + modelViewMatrix * vec4(offset, 0.0);
      view = at.xyz;
      bent = normalMatrix * outward;
      gl_Position = projectionMatrix * at;
    }`;
  const symbolFragment = cut + light + `
    uniform vec3 colour;
    varying vec3 bent;
    varying vec3 view;
    void main() {
      cutBehindPlane();
      gl_FragColor = vec4(colour * lightOn(normalize(bent), view), 1.0);
    }`;

  function texture(bytes, filter) {
    const result = new THREE.DataTexture(bytes, bytes.length / 4, 1, THREE.RGBAFormat);
    result.minFilter = result.magFilter = filter;
    result.needsUpdate = true;
    return result;
  }

  // Values that all shaders share: one change moves, cuts and colours everything.
  isopatch.makeUniforms = function () {
    return {
      scale: {value: 0}, plane: {value: new THREE.Vector4(0, 0, 0, 1)}, range: {value: new THREE.Vector2(0, 1)},
      bands: {value: 0}, ink: {value: new THREE.Color()}, categories: {value: 0}, colours: {value: null},
      noValue: {value: new THREE.Color(isopatch.noValueColour)},
      maps: {continuous: texture(isopatch.mapBytes(256), THREE.LinearFilter),
             categorical: texture(isopatch.categoryBytes(), THREE.NearestFilter)}};
  };

  function material(shared, own, vertexShader, fragmentShader, settings) {
    const {maps, ...uniforms} = shared;
    return new THREE.ShaderMaterial({uniforms: {...uniforms, ...own}, vertexShader, fragmentShader,
                                     side: THREE.DoubleSide, extensions: {derivatives: true}, ...settings});
  }

  isopatch.surfaceMaterial = (shared) => material(shared, {opacity: {value: 1}}, surfaceVertex, surfaceFragment, {});
  isopatch.lineMaterial = (shared, opacity) => material(
    shared, {opacity: {value: opacity}, isPlain: {value: 0}}, lineVertex, lineFragment,
    {transparent: true, depthWrite: false});  // drawn after all that is opaque
  isopatch.symbolMaterial = (shared, colour) => material(
    shared, {colour: {value: new THREE.Color(colour)}}, symbolVertex, symbolFragment, {});

  isopatch.setOpacity = function (surface, opacity) {
    surface.uniforms.opacity.value = opacity;
    surface.transparent = opacity < 1;
    surface.depthWrite = opacity >= 1;
  };
})(globalThis.isopatch);
