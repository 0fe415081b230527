import {
  DataTexture,
  GLSL3,
  RGBAFormat,
  ShaderMaterial,
  UnsignedByteType,
  Vector2,
  type IUniform,
} from 'three';
import { rampTexels } from '../colours';

const kVertexShader = /* glsl */ `
in float px; in float py; in float pz;
in float intensity; in float label; in float time; in float ring; in float ground;
uniform int uMode;
uniform int uChannels;
uniform float uSize;
uniform float uFade;
uniform vec2 uRange;
uniform sampler2D uLabels;
uniform sampler2D uRamp;
out vec3 vColour;

const vec3 kUnknown = vec3(0.55, 0.58, 0.62);

vec3 ramp(float value) {
  float share = (value - uRange.x) / max(1e-6, uRange.y - uRange.x);
  return texture(uRamp, vec2((clamp(share, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

vec3 colour(vec4 named, float height) {
  if (uMode == 1) return ramp(height);
  if (uMode == 3) return abs(ground) < 1e6 ? ramp(ground) : kUnknown;
  if (uMode == 0) return (uChannels & 2) != 0 ? named.rgb : kUnknown;
  if (uMode == 2) return (uChannels & 1) != 0 ? ramp(intensity) : kUnknown;
  if (uMode == 4) return (uChannels & 4) != 0 ? ramp(time / 255.0) : kUnknown;
  return (uChannels & 8) != 0 ? ramp(ring) : kUnknown;
}

void main() {
  vec4 world = modelMatrix * vec4(px, py, pz, 1.0);
  vec4 named = texelFetch(uLabels, ivec2(int(label + 0.5), 0), 0);
  gl_Position = projectionMatrix * viewMatrix * world;
  // A hidden label is moved out of the view, which costs less than to throw its pixels away.
  if ((uChannels & 2) != 0 && named.a < 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = uSize * clamp(12.0 / gl_Position.w, 1.0, 3.0);
  vColour = colour(named, world.z) * uFade;
}`;

const kFragmentShader = /* glsl */ `
in vec3 vColour;
out vec4 fragColour;
void main() {
  vec2 at = 2.0 * gl_PointCoord - 1.0;
  if (dot(at, at) > 1.0) discard;
  fragColour = vec4(vColour, 1.0);
}`;

function texture(texels: Uint8Array<ArrayBuffer>): DataTexture {
  const made = new DataTexture(texels, 256, 1, RGBAFormat, UnsignedByteType);
  made.needsUpdate = true;
  return made;
}

/** What all points of a run have in common; a change shows in all of them at once. */
export class PointStyle {
  readonly uniforms = {
    uMode: { value: 0 } as IUniform<number>,
    uSize: { value: 2 } as IUniform<number>,
    uRange: { value: new Vector2(0, 1) },
    uLabels: { value: texture(new Uint8Array(4 * 256).fill(255)) },
    uRamp: { value: texture(rampTexels('viridis')) },
  };

  setLabels(texels: Uint8Array<ArrayBuffer>): void {
    this.uniforms.uLabels.value.dispose();
    this.uniforms.uLabels.value = texture(texels);
  }

  setRamp(texels: Uint8Array<ArrayBuffer>): void {
    this.uniforms.uRamp.value.dispose();
    this.uniforms.uRamp.value = texture(texels);
  }

  material(channels: number): ShaderMaterial {
    return new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: kVertexShader,
      fragmentShader: kFragmentShader,
      uniforms: { ...this.uniforms, uChannels: { value: channels }, uFade: { value: 1 } },
    });
  }
}
