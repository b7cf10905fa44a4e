"""Cases whose files are written by hand: what gmsh's kernel does not write."""

import re

from expected import Body, Case, box_body
from step_text import MILLIMETRE, StepText

CASES = []
SIZE = (1, 2, 3)


def case(name, bodies=(), text=None, **more):
    """Registers a case; the text may be a function, a text or bytes."""
    CASES.append(Case("written/" + name, list(bodies), make=text, **more))


def one(step, product="part", size=SIZE, **more):
    """A file with a block as its only product."""
    step.product(product, [step.block(size, **more)])
    return step


# Units

SI = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({},.METRE.))"


def converted(step_unit_base, factor, name):
    """An imperial unit by its length in another unit; the instances that it needs come first."""

    def make():
        s = StepText(unit=None)
        base = s.add(step_unit_base)
        for i, (f, n) in enumerate(zip(factor, name)):
            measure = s.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({f!r}),{base})")
            powers = s.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
            base = s.add(f"(CONVERSION_BASED_UNIT('{n}',{measure})LENGTH_UNIT()NAMED_UNIT({powers}))")
        angle = s.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        s.context = s.add(
            f"(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT(({base},{angle}))REPRESENTATION_CONTEXT('',''))"
        )
        return one(s).text()

    return make


for label, prefix, metres, unit in (
    ("m", "$", 1, "m"), ("mm", ".MILLI.", 1e-3, "mm"), ("cm", ".CENTI.", 1e-2, "cm"), ("dm", ".DECI.", 0.1, "dm"),
    ("um", ".MICRO.", 1e-6, "um"), ("km", ".KILO.", 1e3, "km"), ("hm", ".HECTO.", 100, None), ("dam", ".DECA.", 10, None),
):
    case(f"unit_{label}.step", [box_body(*SIZE)], lambda p=prefix: one(StepText(unit=SI.format(p))).text(), metres=metres, unit=unit, warns=False)
MM = SI.format(".MILLI.")
for label, base, factors, names, metres, unit in (
    ("inch", MM, [25.4], ["INCH"], 0.0254, "inch"),
    ("inch_of_m", SI.format("$"), [0.0254], ["INCH"], 0.0254, "inch"),
    ("foot", MM, [304.8], ["FOOT"], 0.3048, "foot"),
    ("foot_of_inch", MM, [25.4, 12.0], ["INCH", "FOOT"], 0.3048, "foot"),
    ("yard_of_foot_of_inch", MM, [25.4, 12.0, 3.0], ["INCH", "FOOT", "YARD"], 0.9144, None),
    ("inch_of_foot", SI.format("$"), [0.3048, 1 / 12], ["FOOT", "INCH"], 0.0254, "inch"),
    ("mil", MM, [0.0254], ["MIL"], 2.54e-5, None),
):
    case(f"unit_{label}.step", [box_body(*SIZE)], converted(base, factors, names), metres=metres, unit=unit, warns=False)
case("unit_named_wrongly.step", [box_body(*SIZE)], converted(MM, [10.0], ["INCH"]), metres=1e-2, warns=True, says="INCH")
case("unit_none.step", [box_body(*SIZE)], lambda: one(StepText(unit=None)).text(), warns=True)
case("unit_none_given.step", [box_body(*SIZE)], lambda: one(StepText(unit=None)).text(), metres=0.0254, options=("--length-unit", "0.0254 m"))


def two_units():
    s = StepText()
    s.product("small", [s.block(SIZE)])
    other = s.new_context(SI.format("$"))
    s.product("large", [s.block(SIZE)], context=other)
    return s.text()


case("units_two.step", [box_body(*SIZE), box_body(1000, 2000, 3000)], two_units)

# Names

for label, written, read in (
    ("plain", "bracket 7", "bracket 7"), ("quote", "Peter''s part", "Peter's part"),
    ("x2", "\\X2\\00E4\\X0\\rmel", "\u00e4rmel"), ("x2_several", "\\X2\\4E2D6587\\X0\\", "\u4e2d\u6587"),
    ("x", "\\X\\E4rmel", "\u00e4rmel"), ("s", "\\S\\drmel", "\u00e4rmel"),
    ("x4", "\\X4\\0001F600\\X0\\", "\U0001F600"), ("utf8", "\u00e4rmel \u20ac", "\u00e4rmel \u20ac"),
    ("backslash", "a\\\\b", "a\\b"), ("semicolon", "a;b,(c)=#1", "a;b,(c)=#1"), ("comment", "a/*b*/c", "a/*b*/c"),
    ("long", "x" * 300, "x" * 300), ("slash", "a/b", "a/b"), ("none", "NONE", "name_none"), ("empty", "", "name_empty"),
    ("double_quote", 'M8 "long"', 'M8 "long"'), ("line_break", "two\\X\\0Alines", None),
):
    case(f"name_{label}.step", [box_body(*SIZE, name=read)], lambda w=written: one(StepText(), w).text(), warns=False)
case("name_latin1.step", [box_body(*SIZE, name="\u00e4rmel")], lambda: one(StepText(), "\u00e4rmel").text().encode("latin-1"))
case("name_of_faces.step", [box_body(*SIZE, faces={"a", "b", "c d", "d'", "\u00e9", "f"})],
     lambda: one(StepText(), names=["a", "b", "c d", "d''", "\\X2\\00E9\\X0\\", "f"]).text(), warns=False)
case("name_of_solid_only.step", [box_body(*SIZE, name="name_of_solid_only")], lambda: one(StepText(), "", name="inner").text())


def named_solids():
    s = StepText()
    s.product("parts", [s.block(SIZE, name="left"), s.block(SIZE, (5, 0, 0), name="right")])
    return s.text()


case("name_of_solids.step", [box_body(*SIZE, name="left"), box_body(*SIZE, (5, 0, 0), name="right")], named_solids)

# Colours


def coloured(solid=None, faces=(), named=None, schema="AP214"):
    s = StepText(schema)
    block_faces = s.block_faces(SIZE)
    brep = s.add(f"MANIFOLD_SOLID_BREP('',{s.shell(block_faces)})")
    s.product("part", [brep])
    styled = [s.colour(block_faces[i], rgb) for i, rgb in faces]
    if solid or named:
        styled.append(s.colour(brep, solid, named))
    s.styles(styled)
    return s.text()


for schema in ("AP203", "AP214", "AP242"):
    case(f"colour_solid_{schema}.step", [box_body(*SIZE, colours={"#336699"})], lambda c=schema: coloured((0.2, 0.4, 0.6), schema=c))
    case(f"colour_faces_{schema}.step", [box_body(*SIZE, colours={None, "#ff0000", "#00ff80"})],
         lambda c=schema: coloured(faces=[(0, (1, 0, 0)), (3, (0, 1, 128 / 255))], schema=c))
case("colour_both.step", [box_body(*SIZE, colours={"#0000ff", "#ff0000"})], lambda: coloured((0, 0, 1), [(2, (1, 0, 0))]))
case("colour_named.step", [box_body(*SIZE, colours={"#ff0000"})], lambda: coloured(named="red"))

# Assemblies


def assembled(places, levels=1, related=False, colour=False, schema="AP214"):
    s = StepText(schema)
    brep = s.block(SIZE, name="solid")
    part = s.product("PART", [brep], related=related)
    if colour:
        s.styles([s.colour(brep, (1, 0, 0))])
    for level in range(levels):
        whole = s.assembly(f"LEVEL{level}")
        for place in places:
            s.place(whole, part, **place)
        part = whole
    return s.text()


MOVES = [{"origin": (0, 0, 0)}, {"origin": (10, 0, 0)}, {"origin": (0, 10, 0), "z": (1, 0, 0), "x": (0, 1, 0)}]
BOXES = [((0, 0, 0), (1, 2, 3)), ((10, 0, 0), (11, 2, 3)), ((0, 10, 0), (3, 11, 2))]
TURNED = [Body(6, 22, box=b, name=n, stage="parameterization") for b, n in zip(BOXES, ("PART", "PART#1", "PART#2"))]
for schema in ("AP203", "AP214", "AP242"):
    case(f"assembly_three_places_{schema}.step", TURNED, lambda c=schema: assembled(MOVES, schema=c), warns=False)
case("assembly_related_shape.step", TURNED, lambda: assembled(MOVES, related=True), warns=False)
case("assembly_coloured.step", [Body(6, 22, box=b, colours={"#ff0000"}) for b in BOXES], lambda: assembled(MOVES, colour=True))
STEPS = [{"origin": (0, 0, 0)}, {"origin": (10, 0, 0)}]
case("assembly_five_levels.step", [Body(6, 22) for _ in range(32)], lambda: assembled(STEPS, levels=5), warns=False)
case("assembly_one_place.step", [box_body(*SIZE, (7, 8, 9), name="PART")], lambda: assembled([{"origin": (7, 8, 9)}]))


def empty_part():
    s = StepText()
    part = s.product("PART", [s.block(SIZE)])
    hollow = s.product("NOTHING", [], "SHAPE_REPRESENTATION")
    whole = s.assembly("ALL")
    s.place(whole, part)
    s.place(whole, hollow)
    return s.text()


case("assembly_with_empty_part.step", [box_body(*SIZE, name="PART")], empty_part)


def circular():
    s = StepText()
    part = s.product("PART", [s.block(SIZE)])
    a, b = s.assembly("A"), s.assembly("B")
    s.place(a, b)
    s.place(b, a)
    s.place(a, part)
    return s.text()


case("assembly_in_a_circle.step", text=circular, code=(0, 2, 3))


def two_roots():
    s = StepText()
    s.product("ONE", [s.block(SIZE)])
    s.product("TWO", [s.block(SIZE, (5, 0, 0))])
    return s.text()


case("two_products.step", [box_body(*SIZE, name="ONE"), box_body(*SIZE, (5, 0, 0), name="TWO")], two_roots, warns=False)


def mapped(operator):
    s = StepText()
    part = s.product("PART", [s.block(SIZE)])
    frame = s.axes()
    source = s.add(f"REPRESENTATION_MAP({frame},{part[1]})")
    target = operator(s)
    item = s.add(f"MAPPED_ITEM('',{source},{target})")
    s.product("ALL", [item], "SHAPE_REPRESENTATION")
    return s.text()


def mirror(s):
    axes = [s.direction(d) for d in ((-1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return s.add(f"CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',{axes[0]},{axes[1]},{s.point((0, 0, 0))},1.,{axes[2]})")


def doubled(s):
    axes = [s.direction(d) for d in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return s.add(f"CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',{axes[0]},{axes[1]},{s.point((9, 0, 0))},2.,{axes[2]})")


case("mapped_moved.step", text=lambda: mapped(lambda s: s.axes((20, 0, 0))), code=(0, 2))
case("mapped_mirrored.step", text=lambda: mapped(mirror), code=(0, 2))
case("mapped_doubled.step", text=lambda: mapped(doubled), code=(0, 2))

# Bodies in other words


def surface_model(groups, kinds, solids=0, schema="AP214"):
    s = StepText(schema)
    shells = [s.shell(s.block_faces(SIZE, low, skip=skip), kind) for (low, skip), kind in zip(groups, kinds)]
    items = [s.add(f"SHELL_BASED_SURFACE_MODEL('',({','.join(shells)}))")] if shells else []
    items += [s.block(SIZE, (0, 10 * (i + 1), 0)) for i in range(solids)]
    s.product("part", items, "MANIFOLD_SURFACE_SHAPE_REPRESENTATION")
    return s.text()


A, B = ((0, 0, 0), ()), ((10, 0, 0), ())
OPEN = ((20, 0, 0), (2,))
CLOSED = "CLOSED_SHELL"
case("shell_closed.step", [box_body(*SIZE)], lambda: surface_model([A], [CLOSED]), warns=False)
case("shell_called_open.step", [box_body(*SIZE)], lambda: surface_model([A], ["OPEN_SHELL"]))
case("shells_two.step", [box_body(*SIZE), box_body(*SIZE, (10, 0, 0))], lambda: surface_model([A, B], [CLOSED] * 2), warns=False)
case("shell_and_solids.step", [box_body(*SIZE), box_body(*SIZE, (0, 10, 0)), box_body(*SIZE, (0, 20, 0))], lambda: surface_model([A], [CLOSED], 2))
OPEN_BODY = Body(0, 19, stage="repair", genus=None)  # described, then refused
case("shell_open_beside_solid.step", [OPEN_BODY, box_body(*SIZE, (0, 10, 0))], lambda: surface_model([OPEN], ["OPEN_SHELL"], 1), code=2, says="open")
case("shell_open.step", [OPEN_BODY], lambda: surface_model([OPEN], ["OPEN_SHELL"]), code=2, says="open")


def one_shell_of_two():
    s = StepText()
    shell = s.shell(s.block_faces(SIZE) + s.block_faces(SIZE, (10, 0, 0)))
    s.product("part", [s.add(f"MANIFOLD_SOLID_BREP('',{shell})")])
    return s.text()


case("one_shell_of_two_bodies.step", [box_body(*SIZE), box_body(*SIZE, (10, 0, 0))], one_shell_of_two)


def with_void(inward=True):
    s = StepText()
    outer = s.shell(s.block_faces((10, 10, 10)))
    inner = s.shell(s.block_faces((2, 3, 4), (3, 3, 3), inward=inward))
    void = s.add(f"ORIENTED_CLOSED_SHELL('',*,{inner},{'.T.' if inward else '.F.'})")
    s.product("part", [s.add(f"BREP_WITH_VOIDS('',{outer},({void}))")])
    return s.text()


VOID = Body(976, 652, shells=2)
case("void.step", [VOID], with_void, warns=False)
case("void_of_reversed_shell.step", [VOID], lambda: with_void(False), warns=False)


def faceted():
    s = StepText()
    shell = s.shell(s.block_faces(SIZE, poly=True))
    s.product("part", [s.add(f"FACETED_BREP('',{shell})")], "FACETED_BREP_SHAPE_REPRESENTATION")
    return s.text()


case("faceted.step", [box_body(*SIZE)], faceted, warns=False)
case("inside_out.step", [box_body(*SIZE)], lambda: one(StepText(), inward=True).text())
case("lost_face.step", [Body(0, 19, stage="repair", genus=None)], lambda: one(StepText(), skip=(2,)).text(), code=2, says="open")


def beside(extra, schema="AP242"):
    s = StepText(schema)
    s.product("part", [s.block(SIZE)])
    extra(s)
    return s.text()


def curves(s):
    line = s.add(f"LINE('',{s.point((0, 0, 0))},{s.add(f'VECTOR({chr(39) * 2},{s.direction((1, 0, 0))},1.)')})")
    trimmed = s.add(f"TRIMMED_CURVE('',{line},(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(5.)),.T.,.PARAMETER.)")
    s.product("wires", [s.add(f"GEOMETRIC_CURVE_SET('',({trimmed}))")], "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION")


def triangles(s):
    points = s.add("COORDINATES_LIST('',4,((0.,0.,0.),(1.,0.,0.),(0.,1.,0.),(0.,0.,1.)))")
    face = s.add(f"TRIANGULATED_FACE('',{points},4,(),$,(),((1,3,2),(1,2,4),(1,4,3),(2,3,4)))")
    solid = s.add(f"TESSELLATED_SOLID('',({face}),$)")
    s.product("mesh", [solid], "TESSELLATED_SHAPE_REPRESENTATION")


case("curves_beside_a_solid.step", [box_body(*SIZE)], lambda: beside(curves))
case("triangles_beside_a_solid.step", [box_body(*SIZE)], lambda: beside(triangles))


def only(extra):
    s = StepText("AP242")
    extra(s)
    return s.text()


case("only_curves.step", text=lambda: only(curves), code=(2, 3), says="no solid")
case("only_triangles.step", text=lambda: only(triangles), code=(2, 3), says="TESSELLATED")

# Ways to write the same

PLAIN = [box_body(*SIZE, name="part")]


def plain(arrange=lambda lines: lines, end="\n", first=1):
    return one(StepText(first=first)).text(arrange, end)


def spread(text):
    """A break after each comma, comments and tabs between."""
    head, data = text.split("DATA;")
    return head + "DATA;" + re.sub(r",(?![^']*'[,)])", " ,\n\t/* a , comment; */ ", data)


case("crlf.step", PLAIN, lambda: plain(end="\r\n"), warns=False)
case("one_line.step", PLAIN, lambda: plain(end=""), warns=False)
case("spread.step", PLAIN, lambda: spread(plain()), warns=False)
case("backwards.step", PLAIN, lambda: plain(lambda lines: lines[::-1]), warns=False)
case("large_numbers.step", PLAIN, lambda: plain(first=2_000_000_000), warns=False)
case("larger_numbers.step", PLAIN, lambda: plain(first=20_000_000_000), code=(0, 2, 3))
case("leading_zeros.step", PLAIN, lambda: re.sub(r"#(\d)", r"#00\1", plain()), warns=False)
case("spaces_around.step", PLAIN, lambda: plain().replace("=", " = ").replace("(", " ( ").replace(")", " ) "), warns=False)
case("comment_first.step", PLAIN, lambda: "/* by hand */\n" + plain(), warns=False)
case("blank_first.step", PLAIN, lambda: "\n\n  " + plain(), warns=False)
case("byte_order_mark.step", PLAIN, lambda: "\ufeff" + plain(), warns=False)
case("after_the_end.step", PLAIN, lambda: plain() + "\n\x1a", warns=False)
case("exponents.step", PLAIN, lambda: re.sub(r"\b([123])\.0\b", r"0.\1e+1", plain()), warns=False)
for label, form in (("E", "0.1E+1"), ("no_point", "1"), ("plus", "+1."), ("E_without_point", "1E0"), ("point_E", "1.E0"), ("zeros", "001.000"),
                    ("small_E_digits", "10.e-1"), ("many_digits", "1.0000000000000000000000000000000000000000"), ("E_plus_zeros", "1.E+000")):
    case(f"number_{label}.step", PLAIN, lambda f=form: re.sub(r"(?<![-.\d])1\.0\b", f, plain()), warns=False)
case("number_begins_with_a_point.step", [box_body(0.5, 2, 3)], lambda: one(StepText(), size=(0.5, 2, 3)).text().replace("0.5", ".5"), warns=False)
case("small_keywords.step", PLAIN, lambda: re.sub(r"=([A-Z_0-9]+)\(", lambda m: "=" + m.group(1).lower() + "(", plain()), code=(0, 2))
case("small_enumerations.step", PLAIN, lambda: plain().replace(".T.", ".t.").replace(".F.", ".f."), code=(0, 2))
case("integers_for_reals.step", PLAIN, lambda: re.sub(r"\b(\d)\.0(?=[,)])", r"\1", plain()), warns=False)
case("two_data_sections.step", PLAIN, lambda: plain(lambda lines: lines[:9] + ["ENDSEC;", "DATA;"] + lines[9:]), code=(0, 2))
case("user_defined_entity.step", PLAIN, lambda: plain(lambda lines: lines + ["#90001=!OURS('a',1,$,(2.,3.));"]), code=(0,))
case("unknown_entity.step", PLAIN, lambda: plain(lambda lines: lines + ["#90001=NEVER_HEARD_OF('a',1,$,(2.,3.));"]), code=(0,))
case("ending_stp.stp", PLAIN, plain, warns=False)
case("ending_p21.p21", PLAIN, plain, warns=False)
case("ending_capitals.STEP", PLAIN, plain, warns=False)
case("ending with spaces.step", PLAIN, plain, warns=False)
case("ending_\u00e4\u00f6.step", PLAIN, plain, warns=False)

# Refusals

HEADER = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n"
BAD = (2, 3)
RUBBISH = bytes((i * 7919 + i * i * 31) % 256 for i in range(5000))
for ending in ("step", "igs", "brep"):
    case(f"no_bytes.{ending}", text=b"", code=BAD)
    case(f"rubbish.{ending}", text=RUBBISH, code=BAD)
    case(f"zeros.{ending}", text=bytes(4000), code=BAD)
    case(f"one_word.{ending}", text=b"solid\n", code=BAD)
case("header_only.step", text=HEADER + "END-ISO-10303-21;\n", code=BAD)
case("no_data.step", text=HEADER + "DATA;\nENDSEC;\nEND-ISO-10303-21;\n", code=BAD)
case("cut_in_half.step", text=lambda: plain()[:3000], code=BAD, says="cut")
case("product_without_shape.step", text=lambda: only(lambda s: s.assembly("empty")), code=BAD)
case("step_as_brep.brep", text=plain, code=BAD)
case("step_as_iges.igs", text=plain, code=BAD)
case("double_number.step", text=lambda: plain(lambda lines: lines + lines[-1:]), code=BAD, says="before")
case("unknown_reference.step", text=lambda: plain().replace("CLOSED_SHELL('',(#", "CLOSED_SHELL('',(#999"), code=(0, 2, 3), says="#999")
case("not_a_number.step", text=lambda: plain().replace("(1.0,2.0,3.0)", "(1.0,nan,3.0)"), code=BAD)
case("infinite.step", text=lambda: plain().replace("(1.0,2.0,3.0)", "(1.0,1.E999,3.0)"), code=BAD, says="number")
case("deep_brackets.step", text=lambda: plain(lambda lines: lines + ["#90001=A(" + "(" * 5000 + ")" * 5001 + ";"]), code=BAD)
case("huge_counts.brep", text="DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 2000000000\n", code=BAD)
case("huge_surface_counts.brep", text="DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 0\nCurve2ds 0\nCurves 0\nPolygon3D 0\n"
     "PolygonOnTriangulations 0\nSurfaces 1\n9 0 0 0 0 3 3 1500000000 1500000000 2 2\nTriangulations 0\n\nTShapes 0\n\n*\n", code=BAD)
case("memory_limit.step", text=plain, code=BAD, says="memory", options=("--cad-memory-limit", "20000000"))
case("time_limit.step", text=plain, code=BAD, says="stopped", options=("--cad-time-limit", "0.001"))
