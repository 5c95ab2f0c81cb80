// 3-D view of the disk on its table at the current time, with contact, path of the contact and force.
import * as THREE from 'three'
import { at, place } from './data.js'
import { Stage, theme } from './stage.js'

const PATH_POINTS = 400 // points of the drawn path
const PATH_TURNS = 3 // turns of the contact covered by the drawn path

export class Disk3D {
  constructor(canvas, run) {
    const { disk, motion } = run
    Object.assign(this, { disk, motion, delay: run.delay })
    this.stage = new Stage(canvas, 6 * disk.radius)
    this.body = body(disk)
    this.stage.scene.add(table(disk), this.body)
    if (disk.mirror) {
      this.image = this.body.clone()
      const reflection = new THREE.Group()
      reflection.scale.z = -1
      this.stage.scene.add(reflection.add(this.image))
    }
    this.contact = new THREE.Mesh(
      new THREE.SphereGeometry(0.03 * disk.radius, 16, 12),
      new THREE.MeshBasicMaterial({ color: theme('--contact') }),
    )
    this.force = new THREE.ArrowHelper(new THREE.Vector3(0, 0, 1), new THREE.Vector3(), 1, theme('--force'))
    this.trail = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: theme('--contact') }))
    this.trail.geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * PATH_POINTS), 3))
    this.trail.frustumCulled = false
    this.stage.scene.add(this.contact, this.force, this.trail)
  }

  /** Draw the state at the listener's time `time`. */
  draw(time) {
    const t = Math.min(Math.max(time - this.delay, this.motion.t[0]), this.motion.t.at(-1))
    if (t !== this.shown) {
      this.shown = t
      this.#pose(this.#state(t))
      this.#draw(t)
      this.stage.stale = true
    }
    this.stage.draw()
  }

  #state(t) {
    return Object.fromEntries(this.motion.columns.map((name) => [name, at(this.motion.t, this.motion[name], t)]))
  }

  // x points from the centre to the contact within the face, z along the axis: -e3, e2 of (2.1).
  #pose({ precession, inclination, spin, x, y }) {
    const [c, s] = [Math.cos(inclination), Math.sin(inclination)]
    const [ax, ay] = towards(precession)
    const outward = new THREE.Vector3(c * ax, c * ay, -s)
    const axis = new THREE.Vector3(s * ax, s * ay, c)
    const across = new THREE.Vector3().crossVectors(axis, outward)
    const { contact } = this.disk
    this.body.position.set(x, y, at(contact.inclination, contact.height, inclination))
    this.body.setRotationFromMatrix(new THREE.Matrix4().makeBasis(outward, across, axis))
    this.body.rotateZ(spin)
    this.image?.position.copy(this.body.position)
    this.image?.quaternion.copy(this.body.quaternion)
    this.contact.position.set(...this.#contact({ precession, inclination, x, y }))
  }

  #contact({ precession, inclination, x, y }) {
    const { contact } = this.disk
    const reach = at(contact.inclination, contact.reach, inclination)
    const [ax, ay] = towards(precession)
    return [x + reach * ax, y + reach * ay, 1e-4]
  }

  #draw(t) {
    const { precession, friction_1, friction_2, normal } = this.#state(t)
    const [ax, ay] = towards(precession)
    const force = new THREE.Vector3(friction_1 * ay + friction_2 * ax, -friction_1 * ax + friction_2 * ay, normal)
    const { radius, weight } = this.disk
    this.force.position.copy(this.contact.position)
    this.force.setDirection(force.clone().normalize())
    this.force.setLength(Math.max((0.8 * radius * force.length()) / weight, 1e-6), 0.18 * radius, 0.09 * radius)
    const turn = this.motion.precession
    const now = place(this.motion.t, t)
    let first = now
    while (first > 0 && Math.abs(turn[now] - turn[first]) < 2 * Math.PI * PATH_TURNS) first--
    const positions = this.trail.geometry.attributes.position
    for (let i = 0; i < PATH_POINTS; i++) {
      const back = this.motion.t[first] + (i / (PATH_POINTS - 1)) * (t - this.motion.t[first])
      positions.setXYZ(i, ...this.#contact(this.#state(back)))
    }
    positions.needsUpdate = true
  }
}

// a_2 is horizontal and points from the centre to the contact; a_1 is (y, -x) of a_2.
const towards = (precession) => [-Math.sin(precession), Math.cos(precession)]

function body({ radius, thickness, inner_radius: hole, edge }) {
  // pairs of distances from the axis and from the middle plane, from the face to the lateral surface
  const rounded = Array.from({ length: edge.length / 2 }, (_, i) => [edge[2 * i], edge[2 * i + 1]])
  const lower = rounded.map(([r, depth]) => [r, -depth])
  const inner = [[hole, thickness / 2], ...(hole ? [[hole, -thickness / 2]] : [])]
  const outline = [[hole, -thickness / 2], ...lower, ...rounded.reverse(), ...inner]
  const points = outline.map(([r, z]) => new THREE.Vector2(Math.max(r, 1e-9), z))
  const solid = new THREE.Mesh(
    new THREE.LatheGeometry(points, 96).rotateX(Math.PI / 2),
    new THREE.MeshStandardMaterial({ color: theme('--steel'), metalness: 0.55, roughness: 0.35, flatShading: true, side: THREE.DoubleSide }),
  )
  const paint = new THREE.MeshBasicMaterial({ color: theme('--mark'), side: THREE.DoubleSide })
  const [from, angle] = [-0.15, 0.3] // [rad], of the mark on face and rim
  const face = new THREE.Mesh(new THREE.RingGeometry(Math.max(0.45 * radius, hole), 0.99 * edge[0], 12, 1, from, angle), paint)
  face.position.z = 0.505 * thickness
  const lateral = 2 * edge.at(-1) // its height
  const rim = new THREE.Mesh(new THREE.CylinderGeometry(1.004 * radius, 1.004 * radius, lateral, 12, 1, true, from + Math.PI / 2, angle), paint)
  rim.rotateX(Math.PI / 2)
  return solid.add(face, rim)
}

function table({ radius, mirror }) {
  const glass = { transparent: true, opacity: 0.7, depthWrite: false, roughness: 0.1 }
  const top = new THREE.Mesh(
    new THREE.CircleGeometry(4 * radius, 96),
    new THREE.MeshStandardMaterial({ color: theme('--table'), ...(mirror ? glass : { roughness: 0.9 }) }),
  )
  const rings = new THREE.PolarGridHelper(4 * radius, 12, 4, 96, theme('--line'), theme('--line')).rotateX(Math.PI / 2)
  rings.position.z = 2e-5
  top.add(rings)
  return top
}
