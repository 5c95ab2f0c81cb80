// 3-D view of one mode shape, animated slowly and exaggerated.
import * as THREE from 'three'
import { Stage, theme } from './stage.js'

const PERIOD = 1.2 // [s], of the animation
export const MAX_DRAWN_DISPLACEMENT = 0.18 // divided by the radius

export class Modes3D {
  constructor(canvas, { points, triangles, shapes }) {
    const isAxial = 3 * shapes[0].length === points.length
    Object.assign(this, { points, shapes: isAxial ? shapes.map(alongZ) : shapes })
    this.radius = Math.max(...points)
    this.stage = new Stage(canvas, 3.6 * this.radius)
    const geometry = new THREE.BufferGeometry()
    geometry.setAttribute('position', new THREE.BufferAttribute(points.slice(), 3))
    geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(points.length), 3))
    geometry.setIndex(new THREE.BufferAttribute(triangles, 1))
    const skin = new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.6, flatShading: true, side: THREE.DoubleSide })
    this.geometry = geometry
    this.stage.scene.add(new THREE.Mesh(geometry, skin))
    this.pick(0)
  }

  pick(number) {
    this.shape = this.shapes[number]
    const most = largest(this.shape)
    this.scale = (MAX_DRAWN_DISPLACEMENT * this.radius) / most
    const [still, far] = [theme('--still'), theme('--far')]
    const colour = this.geometry.attributes.color
    for (let i = 0; i < colour.count; i++) {
      const size = Math.hypot(...this.shape.subarray(3 * i, 3 * i + 3)) / most
      const mixed = still.clone().lerp(far, size)
      colour.setXYZ(i, mixed.r, mixed.g, mixed.b)
    }
    colour.needsUpdate = true
    this.moved(1)
  }

  /** Displace the surface by `phase` times the exaggerated mode shape. */
  moved(phase) {
    const position = this.geometry.attributes.position
    for (let i = 0; i < position.array.length; i++) {
      position.array[i] = this.points[i] + phase * this.scale * this.shape[i]
    }
    position.needsUpdate = true
    this.geometry.computeBoundingSphere()
    this.stage.stale = true
  }

  draw(seconds, still) {
    if (!still) this.moved(Math.cos((2 * Math.PI * seconds) / PERIOD))
    this.stage.draw()
  }
}

/** Return displacements along z as vectors. */
function alongZ(heights) {
  const vectors = new Int16Array(3 * heights.length)
  heights.forEach((height, i) => (vectors[3 * i + 2] = height))
  return vectors
}

function largest(shape) {
  let most = 0
  for (let i = 0; i < shape.length; i += 3) most = Math.max(most, Math.hypot(shape[i], shape[i + 1], shape[i + 2]))
  return most
}
