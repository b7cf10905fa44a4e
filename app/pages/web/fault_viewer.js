// Solids that something is wrong with, in three dimensions: what is faulty in red, all else seen through.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  // {faces, lines, places} decoded, with what a camera needs to know.
  isopatch.readFaults = function (data) {
    const decoded = (item) => ({...item, points: isopatch.decodeBlock(item.points)});
    const {min, max} = data.box;
    const scene = {
      length: data.length, box: data.box, faces: data.faces.map(decoded), lines: data.lines.map(decoded), places: data.places,
      centre: min.map((x, i) => (x + max[i]) / 2), size: Math.hypot(...max.map((x, i) => x - min[i]))};
    const all = [...scene.faces, ...scene.lines].map((item) => item.points);
    scene.points = all.reduce((sum, points) => sum.concat(Array.from(points)), scene.places.flatMap((place) => place.point));
    return scene;
  };

  // A face that crosses itself has no normal, so faulty ones are not lit. Where an edge is wrong its faces step back.
  function faceObject(face, opacity) {
    const geometry = isopatch.geometryOf(face.points, face.triangles);
    geometry.computeVertexNormals();
    const look = {side: THREE.DoubleSide, transparent: true};
    const material = face.is_faulty
      ? new THREE.MeshBasicMaterial({...look, color: isopatch.faultyColour, opacity})
      : new THREE.MeshLambertMaterial({...look, color: "#9fb3c8", opacity: 0.22, depthWrite: false});
    const mesh = new THREE.Mesh(geometry, material);
    mesh.renderOrder = face.is_faulty ? 1 : 2;
    return mesh;
  }

  function lineObject(line, scene, ink) {
    if (!line.is_faulty) return new THREE.Line(isopatch.geometryOf(line.points), ink);
    const corners = [];
    for (let i = 0; i < line.points.length; i += 3) corners.push(new THREE.Vector3(...line.points.slice(i, i + 3)));
    const curve = new THREE.CatmullRomCurve3(corners, false, "centripetal");
    // Where an edge has no length a ball is left.
    const geometry = curve.getLength() > 1e-6 * scene.size
      ? new THREE.TubeGeometry(curve, 4 * corners.length, 0.006 * scene.size, 8)
      : new THREE.SphereGeometry(0.012 * scene.size).translate(...corners[0].toArray());
    return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({color: isopatch.faultyColour}));
  }

  function worldOf(scene, ink) {
    const world = new THREE.Scene();
    const opacity = scene.lines.some((line) => line.is_faulty) ? 0.35 : 0.75;
    world.add(new THREE.HemisphereLight(0xffffff, 0x8899aa, 0.9));
    const sun = new THREE.DirectionalLight(0xffffff, 0.35);
    sun.position.set(-0.4, -0.7, 1);
    world.add(sun, ...scene.faces.filter((face) => face.triangles.length).map((face) => faceObject(face, opacity)),
              ...scene.lines.map((line) => lineObject(line, scene, ink)));
    return world;
  }

  const middleOf = (points) => {
    const count = points.length / 3;
    const result = [0, 0, 0];
    for (let i = 0; i < points.length; ++i) result[i % 3] += points[i] / count;
    return result;
  };

  // A point of the polyline's middle.
  const halfWay = (points) => {
    const at = 3 * Math.floor(points.length / 6);
    return points.length > 6 ? Array.from(points.slice(at, at + 3)) : middleOf(points);
  };

  // What is wrong, each with a name and a point: faces, edges, places.
  isopatch.faultPlaces = function (scene) {
    const named = (list, point) => list.filter((item) => item.is_faulty && item.points.length).map((item) => (
      {name: item.name + (item.remark ? " (" + item.remark + ")" : ""), kind: "warning", point: point(item.points)}));
    return [...named(scene.faces, middleOf), ...named(scene.lines, halfWay),
            ...scene.places.map((place) => ({...place, kind: "max_von_mises"}))];
  };

  isopatch.makeFaultViewer = function (host, scene) {
    const ink = new THREE.LineBasicMaterial({});
    const places = isopatch.faultPlaces(scene);
    const view = isopatch.makeSolidCanvas(host, scene, {
      what: "The solids", world: worldOf(scene, ink), ink, places, points: () => scene.points,
      clicked: (x, y) => choose(view.markers.at(x, y))});
    if (!view) return null;

    function choose(place) {
      view.markers.setPicked(place);
      view.ask();
    }
    return {...view, places, choose};
  };
})(globalThis.isopatch);
