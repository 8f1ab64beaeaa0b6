// Geometries of convex parts: as they are, as a smoothing sees them, and cut by a plane.
import { BufferAttribute, BufferGeometry, Vector3 } from "three";

const corner = (part, index) => new Vector3().fromArray(part.vertices, 3 * index);

/** Triangles of a facet, as a fan. */
function fan(facet) {
  return facet.slice(2).map((_, index) => [facet[0], facet[index + 1], facet[index + 2]]);
}

function geometry(points) {
  const result = new BufferGeometry();
  const coordinates = new Float32Array(3 * points.length);
  points.forEach((point, index) => point.toArray(coordinates, 3 * index));
  result.setAttribute("position", new BufferAttribute(coordinates, 3));
  return result;
}

/** All parts as one flat-shaded geometry. */
export function exactGeometry(parts) {
  const points = parts.flatMap((part) => part.facets.flatMap(fan).flatMap((triangle) => triangle.map((at) => corner(part, at))));
  const result = geometry(points);
  result.computeVertexNormals();
  return result;
}

/** The edges of all parts as line segments. */
export function edgeGeometry(parts) {
  const points = parts.flatMap((part) => {
    const seen = new Set();
    return part.facets.flatMap((facet) =>
      facet.flatMap((from, index) => {
        const to = facet[(index + 1) % facet.length];
        const key = `${Math.min(from, to)}-${Math.max(from, to)}`;
        if (seen.has(key)) return [];
        seen.add(key);
        return [corner(part, from), corner(part, to)];
      }),
    );
  });
  return geometry(points);
}

/** Unit normal and offset of every facet. */
function halfspaces(part) {
  return part.facets
    .filter((facet) => facet.length > 2)
    .map((facet) => {
      const [a, b, c] = [0, 1, 2].map((index) => corner(part, facet[index]));
      const normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
      return { normal, offset: normal.dot(a) };
    });
}

const SUBDIVISIONS = 3;

function subdivided(triangles) {
  const split = ([a, b, c]) => {
    const [ab, bc, ca] = [a.clone().lerp(b, 0.5), b.clone().lerp(c, 0.5), c.clone().lerp(a, 0.5)];
    return [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
  };
  return triangles.flatMap(split);
}

/**
 * Parts as a smoothing sees them: the points p of each with tau sum_i 1 / (offset_i - normal_i p) <= 1. There the
 * smoothed problem of one part has the value zero. Parts that the smoothing swallows are left out.
 */
export function smoothedGeometry(parts, tau) {
  const points = parts.flatMap((part) => {
    const planes = halfspaces(part);
    const centre = Array.from({ length: part.vertices.length / 3 }, (_, index) => corner(part, index))
      .reduce((sum, point) => sum.add(point), new Vector3())
      .multiplyScalar(3 / part.vertices.length);
    const barrier = (point) => planes.reduce((sum, { normal, offset }) => sum + tau / Math.max(offset - normal.dot(point), 1e-12), 0);
    if (barrier(centre) >= 1) return [];
    let triangles = part.facets.flatMap(fan).map((triangle) => triangle.map((at) => corner(part, at)));
    for (let times = 0; times < SUBDIVISIONS; times += 1) triangles = subdivided(triangles);
    const known = new Map();
    const shrunk = (point) => {
      const key = point.toArray().map((value) => value.toFixed(7)).join();
      if (!known.has(key)) known.set(key, levelPoint(centre, point, barrier));
      return known.get(key);
    };
    return triangles.flatMap((triangle) => triangle.map(shrunk));
  });
  const result = geometry(points);
  result.computeVertexNormals();
  return result;
}

/** The point between two where the barrier is one. */
function levelPoint(from, to, barrier) {
  let [low, high] = [0, 1];
  for (let times = 0; times < 24; times += 1) {
    const middle = 0.5 * (low + high);
    if (barrier(from.clone().lerp(to, middle)) < 1) low = middle;
    else high = middle;
  }
  return from.clone().lerp(to, low);
}

/**
 * The polygons in which a plane cuts parts that a matrix places, as triangles: what is inside of a part that is cut open.
 */
export function sectionGeometry(parts, matrix, plane) {
  const points = parts.flatMap((part) => {
    const placed = Array.from({ length: part.vertices.length / 3 }, (_, index) => corner(part, index).applyMatrix4(matrix));
    const heights = placed.map((point) => plane.distanceToPoint(point));
    const cut = [];
    for (const facet of part.facets) {
      facet.forEach((from, index) => {
        const to = facet[(index + 1) % facet.length];
        // Each edge is met twice, once in each direction.
        if (heights[from] < 0 === heights[to] < 0 || from > to) return;
        cut.push(placed[from].clone().lerp(placed[to], heights[from] / (heights[from] - heights[to])));
      });
    }
    return cut.length < 3 ? [] : convexPolygon(cut, plane.normal);
  });
  return geometry(points);
}

/** Triangles of the convex polygon of some points in a plane. */
function convexPolygon(points, normal) {
  const centre = points.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(points.length);
  const first = points[0].clone().sub(centre);
  const second = normal.clone().cross(first);
  const angle = (point) => Math.atan2(point.clone().sub(centre).dot(second), point.clone().sub(centre).dot(first));
  const sorted = points.map((point) => ({ point, angle: angle(point) })).sort((one, other) => one.angle - other.angle);
  return sorted.flatMap(({ point }, index) => [centre, point, sorted[(index + 1) % sorted.length].point]);
}
