// Solids that were cut, in three dimensions: pieces in colours that move apart, T-joints as lines on them.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const lineColour = "#e6007e";
  const calm = "#b4c0cb";  // of finished pieces beside faulty ones

  const vector = (points, i) => [points[3 * i], points[3 * i + 1], points[3 * i + 2]];

  function middleOf(points) {
    const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    points.forEach((x, i) => {
      low[i % 3] = Math.min(low[i % 3], x);
      high[i % 3] = Math.max(high[i % 3], x);
    });
    return low.map((x, c) => (x + high[c]) / 2);
  }

  function decodedPiece(piece, index) {
    const points = isopatch.decodeBlock(piece.points);
    const edges = piece.edges.map(isopatch.decodeBlock);
    const all = [points, ...edges].flatMap((block) => Array.from(block));
    return {...piece, index, points, edges, all, centre: middleOf(all)};
  }

  // The stages decoded, with what a camera needs to know.
  isopatch.readBlocks = function (data) {
    const {min, max} = data.box;
    const stages = data.stages.map((stage) => ({
      ...stage, pieces: stage.pieces.map(decodedPiece),
      lines: stage.lines.map((line) => ({...line, points: isopatch.decodeBlock(line.points)}))}));
    const faces = data.faces.map((face) => ({...face, points: isopatch.decodeBlock(face.points)}));
    return {...data, stages, faces, centre: min.map((x, c) => (x + max[c]) / 2),
            size: Math.hypot(...max.map((x, c) => x - min[c]))};
  };

  isopatch.faultyPieces = (scene) => scene.stages.some((stage) => stage.pieces.some((piece) => piece.is_faulty));

  // How far pieces are apart at first; faces and triangles are better seen where they are.
  const startApart = (scene, stage) => {
    const {apart} = scene.stages[stage];
    return isopatch.faultyPieces(scene) ? 0 : apart === undefined ? 0.5 : apart;
  };
  const asksApart = (scene, before, after) => startApart(scene, before) !== startApart(scene, after);

  isopatch.pieceColour = (stage, piece) => {
    if (piece.is_faulty) return isopatch.faultyColour;
    return stage.pieces.some((other) => other.is_faulty) ? calm : isopatch.categoryOf(piece.index);
  };

  function tube(points, size) {
    const corners = [];
    for (let i = 0; i < points.length / 3; ++i) corners.push(new THREE.Vector3(...vector(points, i)));
    return new THREE.TubeGeometry(new THREE.CatmullRomCurve3(corners, false, "centripetal"), 2 * corners.length, 0.005 * size, 8);
  }

  // The lines of all edges as pairs of points.
  function segments(edges) {
    const numbers = [];
    for (const edge of edges)
      for (let i = 0; i + 1 < edge.length / 3; ++i) numbers.push(...vector(edge, i), ...vector(edge, i + 1));
    return isopatch.geometryOf(new Float32Array(numbers));
  }

  function pieceObject(stage, piece, scene, inks) {
    const geometry = isopatch.geometryOf(piece.points, piece.triangles);
    geometry.computeVertexNormals();
    const seenThrough = piece.is_faulty && scene.faces.length > 0;  // its faults are faces of it
    const material = new THREE.MeshLambertMaterial({
      color: seenThrough ? calm : isopatch.pieceColour(stage, piece), side: THREE.DoubleSide, polygonOffset: true,
      polygonOffsetFactor: 1, polygonOffsetUnits: 1});
    const mesh = new THREE.Mesh(geometry, material);
    const group = new THREE.Group();
    group.add(mesh, new THREE.LineSegments(segments(piece.edges), inks.edges));
    if (stage.shows_triangles) group.add(new THREE.LineSegments(new THREE.WireframeGeometry(geometry), inks.triangles));
    for (const line of stage.lines.filter((one) => one.piece === piece.index)) {
      const drawn = new THREE.Mesh(tube(line.points, scene.size), inks.lines);
      drawn.renderOrder = 4;
      drawn.userData.isLine = true;
      group.add(drawn);
    }
    const direction = new THREE.Vector3(...piece.centre).sub(new THREE.Vector3(...scene.centre));
    return {piece, group, mesh, material, direction, seenThrough};
  }

  function setOpacity(object, opacity) {
    const {material, mesh} = object;
    material.transparent = opacity < 1;
    material.opacity = opacity;
    material.depthWrite = opacity === 1;
    material.needsUpdate = true;
    mesh.renderOrder = opacity < 1 ? 3 : 1;
  }

  // Brightest from above; front, right and back differ.
  function lights() {
    const sky = new THREE.HemisphereLight(0xffffff, 0xb8c0c8, 0.8);
    sky.position.set(0, 0, 1);
    return [sky, ...[[-0.5, -1, 0.4, 0.22], [1, 0.2, 0.1, 0.06]].map(([x, y, z, strength]) => {
      const sun = new THREE.DirectionalLight(0xffffff, strength);
      sun.position.set(x, y, z);
      return sun;
    })];
  }

  function faultyFaces(scene) {
    const group = new THREE.Group();
    for (const face of scene.faces.filter((one) => one.triangles.length))
      group.add(new THREE.Mesh(isopatch.geometryOf(face.points, face.triangles), new THREE.MeshBasicMaterial({
        color: isopatch.faultyColour, side: THREE.DoubleSide, transparent: true, opacity: 0.7})));
    return group;
  }

  isopatch.makeBlockViewer = function (host, scene) {
    const inks = {edges: new THREE.LineBasicMaterial({}),
                  triangles: new THREE.LineBasicMaterial({color: 0x000000, transparent: true, opacity: 0.25}),
                  lines: new THREE.MeshBasicMaterial({color: lineColour, depthTest: false, transparent: true, opacity: 0.9})};
    const stages = scene.stages.map((stage) => {
      const objects = stage.pieces.map((piece) => pieceObject(stage, piece, scene, inks));
      const group = new THREE.Group();
      group.add(...objects.map((object) => object.group));
      return {objects, group};
    });
    const world = new THREE.Scene();
    world.add(...lights(), faultyFaces(scene), ...stages.map((stage) => stage.group));
    const state = {stage: scene.stages.length - 1, apart: startApart(scene, scene.stages.length - 1), lines: true, edges: true, chosen: null};
    const listeners = [];
    const offset = (object) => object.direction.clone().multiplyScalar(state.apart);

    function points() {
      const result = [];
      for (const object of stages[state.stage].objects) {
        const moved = offset(object).toArray();
        object.piece.all.forEach((x, i) => result.push(x + moved[i % 3]));
      }
      return result;
    }

    function setPiece(object) {
      object.group.position.copy(offset(object));
      const isOther = state.chosen !== null && state.chosen !== object.piece.index;
      setOpacity(object, isOther ? 0.12 : object.seenThrough ? 0.3 : 1);
      for (const child of object.group.children) if (child.isLineSegments) child.visible = state.edges;
      for (const child of object.group.children) if (child.userData.isLine) child.visible = state.lines;
    }

    function pieceAt(x, y) {
      const caster = new THREE.Raycaster();
      caster.setFromCamera({x: (2 * x) / view.canvas.clientWidth - 1, y: 1 - (2 * y) / view.canvas.clientHeight}, view.camera);
      const {objects} = stages[state.stage];
      const [hit] = caster.intersectObjects(objects.map((object) => object.mesh));
      return hit ? objects.findIndex((object) => object.mesh === hit.object) : null;
    }

    const view = isopatch.makeSolidCanvas(host, {...scene, size: 2.2 * scene.size}, {
      what: "The blocks", world, ink: inks.edges, points, places: scene.places.map((place) => ({...place, kind: "warning"})),
      clicked: (x, y) => {
        const found = pieceAt(x, y);
        change({chosen: found === state.chosen ? null : found});
      }});
    if (!view) return null;

    // Pieces of another stage are others.
    function change(asked) {
      const isOther = "stage" in asked && asked.stage !== state.stage;
      const wanted = isOther && !("apart" in asked) && asksApart(scene, state.stage, asked.stage)
        ? {...asked, apart: startApart(scene, asked.stage)} : asked;
      const moves = ("apart" in wanted && wanted.apart !== state.apart) || isOther;
      if (isOther) state.chosen = null;
      Object.assign(state, wanted);
      stages.forEach((stage, i) => (stage.group.visible = i === state.stage));
      stages[state.stage].objects.forEach(setPiece);
      if (moves) view.fit();
      view.ask();
      for (const listener of listeners) listener(state);
    }

    change({});
    return {...view, state, change, pieceAt, lineColour, on: (listener) => listeners.push(listener),
            offsetOf: (i) => offset(stages[state.stage].objects[i]).toArray()};
  };
})(globalThis.isopatch);
