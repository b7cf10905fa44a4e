"""STEP files written by hand: blocks, products, assemblies, colours."""

SCHEMAS = {
    "AP203": "CONFIG_CONTROL_DESIGN",
    "AP214": "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }",
    "AP242": "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }",
}
MILLIMETRE = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))"


def real(x):
    text = repr(float(x)).upper()
    return text if "." in text else text.replace("E", ".E") if "E" in text else text + "."


def triple(p):
    return "(" + ",".join(real(x) for x in p) + ")"


class StepText:
    """Collects instances; `add` returns "#n"."""

    def __init__(self, schema="AP214", unit=MILLIMETRE, first=1):
        self.schema, self.lines, self.number = schema, [], first - 1
        self.context = self.new_context(unit)
        self.application = self.add("APPLICATION_CONTEXT('mechanical design')")

    def add(self, text):
        self.number += 1
        self.lines.append(f"#{self.number}={text};")
        return f"#{self.number}"

    def new_context(self, unit):
        length = self.add(unit) if unit else None
        angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        space = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
        units = ",".join(u for u in (length, angle, space) if u)
        precision = ""
        if length:
            it = self.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),{length},'distance','')")
            precision = f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({it}))"
        return self.add(
            f"(GEOMETRIC_REPRESENTATION_CONTEXT(3){precision}"
            f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({units}))REPRESENTATION_CONTEXT('',''))"
        )

    # Geometry

    def point(self, p):
        return self.add(f"CARTESIAN_POINT('',{triple(p)})")

    def direction(self, d):
        return self.add(f"DIRECTION('',{triple(d)})")

    def axes(self, origin=(0, 0, 0), z=(0, 0, 1), x=(1, 0, 0)):
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.point(origin)},{self.direction(z)},{self.direction(x)})")

    def faces(self, corners, loops, names=None, inward=False, skip=(), poly=False):
        """Plane faces of a polyhedron; `loops` of corner numbers, counted outward."""
        places = [self.point(p) for p in corners]
        vertices = [self.add(f"VERTEX_POINT('',{p})") for p in places]
        edges, result = {}, []
        for f, loop in enumerate(loops):
            uses = []
            for a, b in zip(loop, loop[1:] + loop[:1]):
                key = (min(a, b), max(a, b))
                if not poly and key not in edges:
                    p, q = corners[key[0]], corners[key[1]]
                    d = [v - u for u, v in zip(p, q)]
                    size = sum(x * x for x in d) ** 0.5
                    vector = self.add(f"VECTOR('',{self.direction([x / size for x in d])},1.)")
                    line = self.add(f"LINE('',{places[key[0]]},{vector})")
                    edges[key] = self.add(f"EDGE_CURVE('',{vertices[key[0]]},{vertices[key[1]]},{line},.T.)")
                if not poly:
                    uses.append(self.add(f"ORIENTED_EDGE('',*,*,{edges[key]},{'.T.' if a < b else '.F.'})"))
            p, q, r = (corners[i] for i in loop[:3])
            u, v = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(q, r)]
            n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            size, length = sum(x * x for x in n) ** 0.5, sum(x * x for x in u) ** 0.5
            plane = self.add(f"PLANE('',{self.axes(p, [x / size for x in n], [x / length for x in u])})")
            if poly:
                ring = self.add(f"POLY_LOOP('',({','.join(places[i] for i in loop)}))")
            else:
                ring = self.add(f"EDGE_LOOP('',({','.join(uses)}))")
            kind = "FACE_SURFACE" if poly else "ADVANCED_FACE"
            bound = self.add(f"FACE_OUTER_BOUND('',{ring},{'.F.' if inward else '.T.'})")
            sense = ".F." if inward else ".T."
            if f not in skip:
                result.append(self.add(f"{kind}('{names[f] if names else ''}',({bound}),{plane},{sense})"))
        return result

    def block_faces(self, size, low=(0, 0, 0), **more):
        x, y, z = low
        X, Y, Z = (a + b for a, b in zip(low, size))
        corners = [(x, y, z), (X, y, z), (X, Y, z), (x, Y, z), (x, y, Z), (X, y, Z), (X, Y, Z), (x, Y, Z)]
        loops = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
        return self.faces(corners, loops, **more)

    def shell(self, faces, kind="CLOSED_SHELL"):
        return self.add(f"{kind}('',({','.join(faces)}))")

    def block(self, size, low=(0, 0, 0), name="", **more):
        shell = self.shell(self.block_faces(size, low, **more))
        return self.add(f"MANIFOLD_SOLID_BREP('{name}',{shell})")

    # Products

    def product(self, name, items, kind="ADVANCED_BREP_SHAPE_REPRESENTATION", context=None, related=False):
        """A product with a shape of the given items; returns (definition, representation)."""
        rules = self.add(f"PRODUCT_CONTEXT('',{self.application},'mechanical')")
        product = self.add(f"PRODUCT('{name}','{name}','',({rules}))")
        version = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        stage = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{self.application},'design')")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{version},{stage})")
        shape = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        context = context or self.context
        frame = self.axes()
        own = self.add(f"{kind}('{name}',({','.join([frame] + list(items))}),{context})")
        if related:  # the product's shape is an empty one, which another one belongs to
            outer = self.add(f"SHAPE_REPRESENTATION('{name}',({frame}),{context})")
            self.add(f"SHAPE_REPRESENTATION_RELATIONSHIP('','',{outer},{own})")
            self.add(f"SHAPE_DEFINITION_REPRESENTATION({shape},{outer})")
            return definition, outer
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({shape},{own})")
        return definition, own

    def assembly(self, name):
        return self.product(name, [], "SHAPE_REPRESENTATION")

    def place(self, whole, part, name="", origin=(0, 0, 0), z=(0, 0, 1), x=(1, 0, 0)):
        """Puts a part into a whole."""
        use = self.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{self.number}','{name}','',{whole[0]},{part[0]},$)")
        shape = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{use})")
        here, there = self.axes(), self.axes(origin, z, x)
        move = self.add(f"ITEM_DEFINED_TRANSFORMATION('','',{here},{there})")
        relation = self.add(
            f"(REPRESENTATION_RELATIONSHIP('','',{part[1]},{whole[1]})"
            f"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({move})SHAPE_REPRESENTATION_RELATIONSHIP())"
        )
        self.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{shape})")
        return use

    def colour(self, item, rgb=None, named=None):
        """Gives a face or a solid a colour; returns the styled item."""
        value = self.add(f"DRAUGHTING_PRE_DEFINED_COLOUR('{named}')" if named else f"COLOUR_RGB('',{triple(rgb)[1:-1]})")
        fill = self.add(f"FILL_AREA_STYLE('',({self.add(f'FILL_AREA_STYLE_COLOUR({chr(39) * 2},{value})')}))")
        side = self.add(f"SURFACE_SIDE_STYLE('',({self.add(f'SURFACE_STYLE_FILL_AREA({fill})')}))")
        style = self.add(f"PRESENTATION_STYLE_ASSIGNMENT(({self.add(f'SURFACE_STYLE_USAGE(.BOTH.,{side})')}))")
        return self.add(f"STYLED_ITEM('color',({style}),{item})")

    def styles(self, items):
        self.add(f"MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({','.join(items)}),{self.context})")

    def text(self, arrange=lambda lines: lines, end="\n"):
        head = [
            "ISO-10303-21;",
            "HEADER;",
            "FILE_DESCRIPTION((''),'2;1');",
            "FILE_NAME('','2026-01-01T00:00:00',(''),(''),'','','');",
            f"FILE_SCHEMA(('{SCHEMAS[self.schema]}'));",
            "ENDSEC;",
            "DATA;",
        ]
        return end.join(head + arrange(self.lines) + ["ENDSEC;", "END-ISO-10303-21;", ""])
