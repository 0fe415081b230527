import {
  DepthTexture,
  GLSL3,
  Mesh,
  NearestFilter,
  OrthographicCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  UnsignedIntType,
  Vector2,
  WebGLRenderTarget,
  type PerspectiveCamera,
  type WebGLRenderer,
} from 'three';

const kVertexShader = /* glsl */ `
out vec2 vUv;
void main() {
  vUv = uv;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

// Eye-dome lighting, Boucheny 2009: a pixel is darker the farther it lies behind its neighbours, in logarithms of depth.
const kFragmentShader = /* glsl */ `
in vec2 vUv;
out vec4 fragColour;
uniform sampler2D uColour;
uniform sampler2D uDepth;
uniform vec2 uPixel;
uniform vec2 uPlanes;
uniform float uStrength;
uniform vec3 uTop;
uniform vec3 uBottom;

float logDepth(vec2 at, out float raw) {
  raw = texture(uDepth, at).r;
  return log2(uPlanes.x * uPlanes.y / (uPlanes.y - raw * (uPlanes.y - uPlanes.x)));
}

void main() {
  float raw;
  float here = logDepth(vUv, raw);
  gl_FragDepth = raw;
  if (raw >= 1.0) {
    fragColour = vec4(mix(uBottom, uTop, vUv.y), 1.0);
    return;
  }
  float behind = 0.0;
  int neighbours = uStrength > 0.0 ? 8 : 0;
  for (int i = 0; i < neighbours; ++i) {
    float angle = 0.7853981634 * float(i);
    float other;
    float depth = logDepth(vUv + 1.4 * uPixel * vec2(cos(angle), sin(angle)), other);
    behind += other >= 1.0 ? 0.0 : clamp(here - depth, 0.0, 0.12);
  }
  fragColour = vec4(texture(uColour, vUv).rgb * exp(-uStrength * behind / 8.0), 1.0);
}`;

/** Draws points into a picture with depth, then that picture to the screen, shaded by depth, and its depth along with it. */
export class EyeDome {
  private readonly target: WebGLRenderTarget;
  private readonly material: ShaderMaterial;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();

  constructor() {
    this.target = new WebGLRenderTarget(1, 1, { minFilter: NearestFilter, magFilter: NearestFilter });
    this.target.depthTexture = new DepthTexture(1, 1, UnsignedIntType);
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: kVertexShader,
      fragmentShader: kFragmentShader,
      uniforms: {
        uColour: { value: this.target.texture },
        uDepth: { value: this.target.depthTexture },
        uPixel: { value: new Vector2() },
        uPlanes: { value: new Vector2() },
        uStrength: { value: 0 },
        uTop: { value: [0.045, 0.06, 0.085] },
        uBottom: { value: [0.085, 0.105, 0.14] },
      },
      depthFunc: 1, // always: the picture brings its own depth
    });
    const quad = new Mesh(new PlaneGeometry(2, 2), this.material);
    quad.frustumCulled = false;
    this.scene.add(quad);
  }

  render(
    renderer: WebGLRenderer,
    points: Scene,
    camera: PerspectiveCamera,
    size: Vector2,
    strength: number,
  ): void {
    if (this.target.width !== size.x || this.target.height !== size.y) this.target.setSize(size.x, size.y);
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(points, camera);
    renderer.setRenderTarget(null);
    const { uPixel, uPlanes, uStrength } = this.material.uniforms;
    (uPixel!.value as Vector2).set(1 / size.x, 1 / size.y);
    (uPlanes!.value as Vector2).set(camera.near, camera.far);
    uStrength!.value = strength;
    renderer.render(this.scene, this.camera);
  }
}
