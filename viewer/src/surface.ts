// What is seen of a mesh at each pixel: its normal, how far it is, and its dust, so that light is computed once a pixel, and for none that something hides.

import { GLSL3, Matrix3, Mesh, Scene, ShaderMaterial, Vector3, type BufferGeometry, type PerspectiveCamera, type Texture, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import { target } from './passes';

/** A part of a picture in pixels: the part that the camera's view fills, and what of it is drawn. */
export interface Part {
  view: [x: number, width: number];
  shown: [x: number, width: number];
}

const VERTEX = /* glsl */ `
in float dust;
out vec3 vPosition;
out vec3 vNormal;
out float vDust;
void main() {
  vPosition = position;
  vNormal = normal;
  vDust = dust;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`;

// The normal by its place on an octahedron that is folded into a square.
const FRAGMENT = /* glsl */ `
in vec3 vPosition;
in vec3 vNormal;
in float vDust;
out vec4 seen;
void main() {
  vec3 normal = gl_FrontFacing ? vNormal : -vNormal;
  normal /= abs(normal.x) + abs(normal.y) + abs(normal.z);
  vec2 side = vec2(normal.x < 0.0 ? -1.0 : 1.0, normal.y < 0.0 ? -1.0 : 1.0);
  seen = vec4(normal.z < 0.0 ? (1.0 - abs(normal.yx)) * side : normal.xy, distance(cameraPosition, vPosition), vDust);
}`;

/** GLSL that says what is seen at a pixel: whether anything, and from where its light comes to the eye. */
export const SEEN = /* glsl */ `
uniform sampler2D surface;
uniform vec3 eye;
in vec3 vRay;
bool seen(out vec3 position, out vec3 normal, out float dust) {
  vec4 found = texelFetch(surface, ivec2(gl_FragCoord.xy), 0);
  position = eye + found.z * normalize(vRay);
  normal = vec3(found.xy, 1.0 - abs(found.x) - abs(found.y));
  float folded = max(-normal.z, 0.0);
  normal.xy -= vec2(normal.x < 0.0 ? -folded : folded, normal.y < 0.0 ? -folded : folded);
  normal = normalize(normal);
  dust = found.w;
  return found.z > 0.0;
}`;

/** A square over the whole view, with the ray of each pixel. */
export const SEEN_VERTEX = /* glsl */ `
uniform vec3 ahead;
uniform vec3 across;
uniform vec3 above;
out vec3 vRay;
void main() {
  vRay = ahead + position.x * across + position.y * above;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

export const seenUniforms = (): Record<string, { value: Texture | Vector3 | null }> => ({
  surface: { value: null },
  eye: { value: new Vector3() },
  ahead: { value: new Vector3() },
  across: { value: new Vector3() },
  above: { value: new Vector3() },
});

export class Surface {
  readonly mesh = new Mesh<BufferGeometry, ShaderMaterial>(undefined, new ShaderMaterial({ glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, side: 2 }));
  private readonly scene = new Scene();
  private target: WebGLRenderTarget = target(1, 1, true);

  constructor() {
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  setSize(width: number, height: number): void {
    this.target.setSize(width, height);
  }

  /** Look at the mesh anew, into the lower left corner. */
  draw(renderer: WebGLRenderer, camera: PerspectiveCamera, height: number, parts: readonly Part[]): void {
    for (const { view, shown } of parts) {
      this.target.viewport.set(view[0], 0, view[1], height);
      this.target.scissor.set(shown[0], 0, shown[1], height);
      this.target.scissorTest = true;
      renderer.setRenderTarget(this.target);
      renderer.clear();
      renderer.render(this.scene, camera);
    }
  }

  /** Pixels from, to, to the right and up, outside of which nothing of the mesh is seen in a part of that height. */
  bounds(camera: PerspectiveCamera, height: number, { view, shown }: Part): [left: number, right: number, low: number, high: number] {
    const { geometry } = this.mesh;
    if (!geometry.boundingSphere) geometry.computeBoundingSphere();
    const { center, radius } = geometry.boundingSphere!;
    const middle = center.clone().applyMatrix4(camera.matrixWorldInverse);
    const { elements } = camera.projectionMatrix;
    /** Where the sphere's two tangents in the plane of an axis and the line of sight meet the picture. */
    const across = (axis: 0 | 1, from: number, size: number): [number, number] => {
      const aside = middle.getComponent(axis);
      const away = Math.hypot(aside, middle.z);
      if (!(away > radius && middle.z < 0)) return [from, from + size];
      const [angle, half] = [Math.atan2(aside, -middle.z), Math.asin(radius / away)];
      const ends = [angle - half, angle + half].map((each) => (Math.abs(each) < Math.PI / 2 ? Math.tan(each) : Infinity * Math.sign(each)));
      const [least, most] = ends.map((each) => from + (size * (each * elements[5 * axis]! - elements[8 + axis]! + 1)) / 2);
      return [Math.floor(least!), Math.ceil(most!)];
    };
    const [left, right] = across(0, ...view);
    const [low, high] = across(1, 0, height);
    return [Math.max(left, shown[0]), Math.min(right, shown[0] + shown[1]), Math.max(low, 0), Math.min(high, height)];
  }

  /** What `SEEN` needs to know. */
  tell({ uniforms }: ShaderMaterial, camera: PerspectiveCamera): void {
    const { elements } = camera.projectionMatrix;
    uniforms['surface']!.value = this.target.texture;
    uniforms['eye']!.value.copy(camera.position);
    const turn = new Matrix3().setFromMatrix4(camera.matrixWorld);
    uniforms['ahead']!.value.set(elements[8]! / elements[0]!, elements[9]! / elements[5]!, -1).applyMatrix3(turn);
    uniforms['across']!.value.set(1 / elements[0]!, 0, 0).applyMatrix3(turn);
    uniforms['above']!.value.set(0, 1 / elements[5]!, 0).applyMatrix3(turn);
  }

  /** After a lost context came back. */
  revive(): void {
    this.target = target(this.target.width, this.target.height, true);
  }

  dispose(): void {
    this.target.dispose();
    this.mesh.material.dispose();
  }
}
