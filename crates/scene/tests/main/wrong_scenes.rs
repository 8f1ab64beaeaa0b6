//! Wrong scenes, and what is said about them.

use crate::support::parse;

/// A scene that is right.
const BASE: &str = "\
title = 'base'
[body]
mass = 1.0
inertia = [0.1, 0.1, 0.1]
[[body.part]]
name = 'shaft'
box = [0.02, 0.02, 0.1]
[[environment.part]]
name = 'wall'
vertices = [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0], [0.1, 0, 0.1]]
position = [0.1, 0.0, 0.0]
orientation = [1, 0, 0, 0]
[[environment.part]]
name = 'floor'
normals = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
offsets = [0.5, 0.5, 0.5, 0.5, 0, 0.1]
[contact]
pairs = [['shaft', 'wall'], ['shaft', 'floor']]
[[start]]
name = 'a'
position = [0, 0, 0.09]
orientation = [1, 0, 0, 0]
[goal]
position = [0, 0, 0.06]
orientation = [1, 0, 0, 0]
[impedance]
translational_stiffness = 50.0
rotational_stiffness = 5.0
translational_damping = 14.0
rotational_damping = [1.4, 1.4, 1.4]
[robustness]
offset_magnitude = 0.02
offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]
[horizon]
steps = 10
time_step = 0.04
[cost]
reference = { translational_velocity = 1, terminal_position = 100 }
compliant = { rotational_velocity = 0.1, terminal_orientation = 1000 }
[limits]
translational_velocity = 1.0
torque = 1.0
";

/// What is replaced in the scene, by what, the line of the error (0: it has none), and words of its message.
#[rustfmt::skip]
const CASES: &[(&str, &str, usize, &str)] = &[
    ("title = 'base'", "title = ''", 1, "title is empty: 1 to 100 characters are needed"),
    ("title = 'base'", "title = '  '", 1, "title is empty: 1 to 100 characters are needed"),
    ("title = 'base'", "title = 5", 1, "title = 5: must be text in quotes, not a number"),
    ("title = 'base'", "title = \"a\\nb\"", 1, "title must not contain line breaks or control characters"),
    ("title = 'base'", "title = \"a\\u001Bb\"", 1, "title must not contain line breaks or control characters"),
    ("title = 'base'", "title = \"a\\u2028b\"", 1, "title must not contain line breaks or control characters"),
    ("title = 'base'", "title = 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx'", 1, "title has 101 characters: at most 100 are possible"),
    ("title = 'base'", "title = true", 1, "title = true: must be text in quotes, not true or false"),
    ("title = 'base'", "title = base", 1, "text needs quotes: \"base\""),
    ("title = 'base'", "title = \"base", 1, "the closing quote of a text is missing"),
    ("title = 'base'", "titel = 'base'", 1, "unknown key `titel`, did you mean `title`?"),
    ("title = 'base'", "title = 'base'\ntitle = 'again'", 2, "`title` is given twice"),
    ("title = 'base'", "title: 'base'", 1, "a key needs `=` and a value"),
    ("title = 'base'", "title", 1, "a key needs `=` and a value"),
    ("title = 'base'", "title =", 1, "a value is missing"),
    ("title = 'base'", "= 'base'", 1, "a key is missing"),
    ("title = 'base'", "steps = 10", 1, "unknown key `steps` here: it belongs to [horizon]"),
    ("title = 'base'", "robust = 1", 1, "unknown key `robust`, did you mean `robustness`?"),
    ("[body]", "[bodi]", 2, "unknown key `bodi`, did you mean `body`?"),
    ("[body]", "[[body]]", 2, "body is a single table: write [body], not [[body]]"),
    ("[body]", "[body", 2, "the closing bracket `]` of a header is missing"),
    ("[body]", "body]", 2, "a key needs `=` and a value"),
    ("[body]\n", "[body]\n[body]\n", 3, "`body` is given twice"),
    ("mass = 1.0", "mass = -1", 3, "body.mass = -1: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = 0", 3, "body.mass = 0: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = nan", 3, "body.mass = nan: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = inf", 3, "body.mass = inf: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = -inf", 3, "body.mass = -inf: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = 1e300", 3, "body.mass = 1e300: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = 1e999", 3, "body.mass = 1e999: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = 1e-300", 3, "body.mass = 1e-300: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = 99999999999999999999999999999999999999999999", 3, "body.mass = 99999999999999999999999999999999999999999999: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = 0x7fffffffffffffff", 3, "body.mass = 0x7fffffffffffffff: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = '1'", 3, "body.mass = '1': must be a number, not text in quotes"),
    ("mass = 1.0", "mass = true", 3, "body.mass = true: must be a number, not true or false"),
    ("mass = 1.0", "mass = [1.0]", 3, "body.mass must be a number, not a list"),
    ("mass = 1.0", "mass = { kg = 1.0 }", 3, "body.mass must be a number, not a table"),
    ("mass = 1.0", "mass = 2024-01-01", 3, "body.mass = 2024-01-01: must be a number, not a date or time"),
    ("mass = 1.0", "mass = 1,5", 3, "the line must end here; decimals are written with a point"),
    ("mass = 1.0", "mass = 1 kg", 3, "`1 kg` is not a number; units are left out, and lists need commas"),
    ("mass = 1.0", "mass = 1kg", 3, "`1kg` is not a number; units are left out, and lists need commas"),
    ("mass = 1.0", "mass = .5", 3, "digits are missing before the decimal point"),
    ("mass = 1.0", "mass = 5.", 3, "digits are missing after the decimal point"),
    ("mass = 1.0", "mass = 01", 3, "a number must not begin with a zero"),
    ("mass = 1.0", "mass = 1e", 3, "digits are missing after the `e`"),
    ("mass = 1.0", "mass = --1", 3, "a number has one sign at most"),
    ("mass = 1.0", "mass = NaN", 3, "not a finite number"),
    ("mass = 1.0", "mass = Inf", 3, "not a finite number"),
    ("mass = 1.0", "mas = 1.0", 3, "unknown key `mas`, did you mean `mass`?"),
    ("mass = 1.0", "mass = 1.0\nmass = 2.0", 4, "`mass` is given twice"),
    ("mass = 1.0", "weight = 1.0", 3, "unknown key `weight`; valid are: mass, inertia, part"),
    ("mass = 1.0", "mass.kg = 1.0", 3, "body.mass must be a number, not a table"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = 0.1", 4, "body.inertia = 0.1: must be 3 numbers or a 3x3 matrix, not a number"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, 0.1]", 4, "body.inertia must be 3 numbers or a 3x3 matrix, not 2 numbers"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, 0.1, 0.1, 0.1]", 4, "body.inertia must be 3 numbers or a 3x3 matrix, not 4 numbers"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = []", 4, "body.inertia must be 3 numbers or a 3x3 matrix, not 0 numbers"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, 0.1, 0]", 4, "body.inertia: 0 must lie between 1e-12 and 1e6 kg m^2"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, 0.1, -0.1]", 4, "body.inertia: -0.1 must lie between 1e-12 and 1e6 kg m^2"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, nan, 0.1]", 4, "body.inertia: nan must lie between 1e-12 and 1e6 kg m^2"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, 0.1, 1e-13]", 4, "body.inertia: 1e-13 must lie between 1e-12 and 1e6 kg m^2"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, 0.1, 2e6]", 4, "body.inertia: 2e6 must lie between 1e-12 and 1e6 kg m^2"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = ['a', 0.1, 0.1]", 4, "body.inertia: 'a' must be a number, not text in quotes"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = 'round'", 4, "body.inertia = 'round': must be 3 numbers or a 3x3 matrix, not text in quotes"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[1, 0, 0], [0, 1, 0]]", 4, "body.inertia must have 3 rows, not 2"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]", 4, "body.inertia must have 3 rows, not 4"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[1, 0, 0], [0, 1], [0, 0, 1]]", 4, "each row of body.inertia must have 3 numbers, not 2"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[1, 0, 0], [0, 1, 0, 0], [0, 0, 1]]", 4, "each row of body.inertia must have 3 numbers, not 4"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[1, 0.5, 0], [0, 1, 0], [0, 0, 1]]", 4, "body.inertia must be symmetric (kg m^2)"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[1, 2, 0], [2, 1, 0], [0, 0, 1]]", 4, "body.inertia must be positive definite, with principal values between 1e-12 and 1e6 kg m^2; one is -1.0e0"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[1, 0, 0], 0.1, 0.1]", 4, "each row of body.inertia must be a list of 3 numbers, not a number"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1 0.1 0.1]", 4, "`0.1 0.1 0.1` is not a number; units are left out, and lists need commas"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, 0.1, 0.1", 5, "a comma or the closing bracket `]` of a list is missing"),
    ("[[body.part]]\n", "[body.part]\n", 5, "there may be several: write [[body.part]], not [body.part]"),
    ("[[body.part]]\nname = 'shaft'\nbox = [0.02, 0.02, 0.1]\n", "", 2, "[body] has no part: add a [[body.part]]"),
    ("[[body.part]]\nname = 'shaft'\nbox = [0.02, 0.02, 0.1]\n", "part = []\n", 5, "body.part has 0 entries: it must have at least 1"),
    ("[[body.part]]\nname = 'shaft'\nbox = [0.02, 0.02, 0.1]\n", "part = 1\n", 5, "body.part = 1: must be given as [[body.part]], not a number"),
    ("[[body.part]]\nname = 'shaft'\nbox = [0.02, 0.02, 0.1]\n", "part = [1]\n", 5, "body.part: 1 must be a table, not a number"),
    ("[[body.part]]\n", "[[body.parts]]\n", 5, "unknown key `parts`, did you mean `part`?"),
    ("name = 'shaft'\n", "", 5, "missing key `name` in [[body.part]]: name of the part, unique in its body or environment"),
    ("name = 'shaft'", "name = ''", 6, "body.part.name is empty: 1 to 100 characters are needed"),
    ("name = 'shaft'", "name = ' '", 6, "body.part.name is empty: 1 to 100 characters are needed"),
    ("name = 'shaft'", "name = 5", 6, "body.part.name = 5: must be text in quotes, not a number"),
    ("name = 'shaft'", "name = \"a\\tb\"", 6, "body.part.name must not contain line breaks or control characters"),
    ("name = 'shaft'", "name = '''a\nb'''", 6, "body.part.name must not contain line breaks or control characters"),
    ("name = 'shaft'", "name = 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx'", 6, "body.part.name has 102 characters: at most 100 are possible"),
    ("name = 'shaft'", "nmae = 'shaft'", 6, "unknown key `nmae`, did you mean `name`?"),
    ("name = 'shaft'", "name = 'schaft'", 18, "[body] has no part `shaft`, did you mean `schaft`?"),
    ("box = [0.02, 0.02, 0.1]\n", "", 5, "part `shaft` needs exactly one of `vertices`, `box`, `normals` with `offsets`, `mesh`"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02, 0.02, 0.1]\nmesh = 'a.stl'", 5, "part `shaft` needs exactly one of `vertices`, `box`, `normals` with `offsets`, `mesh`"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02, 0.02]", 7, "body.part.box must have 3 numbers, not 2"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02, 0.02, 0.1, 0.1]", 7, "body.part.box must have 3 numbers, not 4"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.0, 0.02, 0.1]", 7, "body.part.box: 0.0 must lie between 1e-5 and 1000 m"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02, -0.02, 0.1]", 7, "body.part.box: -0.02 must lie between 1e-5 and 1000 m"),
    ("box = [0.02, 0.02, 0.1]", "box = [1e-6, 0.02, 0.1]", 7, "body.part.box: 1e-6 must lie between 1e-5 and 1000 m"),
    ("box = [0.02, 0.02, 0.1]", "box = [1e-5, 0.02, 100]", 7, "body.part.box: the longest edge is more than 1e6 times the shortest"),
    ("box = [0.02, 0.02, 0.1]", "box = [1e4, 0.02, 0.1]", 7, "body.part.box: 1e4 must lie between 1e-5 and 1000 m"),
    ("box = [0.02, 0.02, 0.1]", "box = [inf, 0.02, 0.1]", 7, "body.part.box: inf must lie between 1e-5 and 1000 m"),
    ("box = [0.02, 0.02, 0.1]", "box = 0.1", 7, "body.part.box must be a list of 3 numbers, not a number"),
    ("box = [0.02, 0.02, 0.1]", "box = '0.02, 0.02, 0.1'", 7, "body.part.box must be a list of 3 numbers, not text in quotes"),
    ("box = [0.02, 0.02, 0.1]", "box = ['0.02', '0.02', '0.1']", 7, "body.part.box: '0.02' must be a number, not text in quotes"),
    ("box = [0.02, 0.02, 0.1]", "box = [[0.02, 0.02, 0.1]]", 7, "body.part.box must have 3 numbers, not 1"),
    ("box = [0.02, 0.02, 0.1]", "box = { x = 1, y = 1, z = 1 }", 7, "body.part.box must be a list of 3 numbers, not a table"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02, 0.02, 0.1]\nqqq = 'red'", 8, "unknown key `qqq`; valid are: name, vertices, box, normals, offsets, mesh, model, link, unit, facets, clearance, density, position, orientation"),
    ("box = [0.02, 0.02, 0.1]", "cube = [0.02, 0.02, 0.1]", 7, "unknown key `cube`"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02, 0.02, 0.1]\nunit = 'mm'", 8, "`unit` belongs to `mesh`; everything else is in metres"),
    ("box = [0.02, 0.02, 0.1]", "mesh = 'part.stl'", 7, "a mesh needs its `unit`: one of \"m\", \"cm\", \"mm\", \"inch\""),
    ("box = [0.02, 0.02, 0.1]", "mesh = 'part.stl'\nunit = 'mmm'", 8, "body.part.unit: unknown value `mmm`, did you mean `mm`?"),
    ("box = [0.02, 0.02, 0.1]", "mesh = 'part.stl'\nunit = 0.001", 8, "body.part.unit = 0.001: must be one of \"m\", \"cm\", \"mm\", \"inch\", not a number"),
    ("box = [0.02, 0.02, 0.1]", "mesh = 'gone.stl'\nunit = 'mm'", 7, "mesh gone.stl: cannot be read: No such file or directory (os error 2)"),
    ("box = [0.02, 0.02, 0.1]", "mesh = 5\nunit = 'mm'", 7, "body.part.mesh = 5: must be text in quotes, not a number"),
    ("box = [0.02, 0.02, 0.1]", "mesh = ''\nunit = 'mm'", 7, "body.part.mesh is empty"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02, 0.02, 0.1]\nposition = [0, 0, 2000]", 8, "body.part.position: 2000 must lie between -1000 and 1000 m"),
    ("[[environment.part]]\nname = 'wall'", "[[enviroment.part]]\nname = 'wall'", 8, "unknown key `enviroment`, did you mean `environment`?"),
    ("name = 'wall'", "name = 'floor'", 14, "part name `floor` is used twice"),
    ("vertices = [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0], [0.1, 0, 0.1]]", "vertices = [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0]]", 10, "environment.part.vertices has 3 entries: it must have at least 4"),
    ("vertices = [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0], [0.1, 0, 0.1]]", "vertices = [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0], [0.1, 0.2, 0]]", 10, "part `wall`: the part is flat: its thickness is below 2.0e-8 m"),
    ("vertices = [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0], [0.1, 0, 0.1]]", "vertices = [[0.1, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0], [0.1, 0, 0.1]]", 10, "part `wall`: 3 distinct vertices do not span a solid: at least 4 are needed"),
    ("vertices = [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0], [0.1, 0, 0.1]]", "vertices = [[1e-9, 0, 0], [2e-9, 0, 0], [0, 1e-9, 0], [0, 0, 1e-9]]", 10, "part `wall`: it is 2.0e-9 m long; parts must be longer than 1e-5 m"),
    ("vertices = [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0], [0.1, 0, 0.1]]", "vertices = []", 10, "environment.part.vertices has 0 entries: it must have at least 4"),
    ("vertices = [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0], [0.1, 0, 0.1]]", "vertices = 'wall.stl'", 10, "environment.part.vertices = 'wall.stl': must be a list, not text in quotes"),
    ("[0.2, 0, 0], [0.1, 0.1, 0]", "[0.2, 0], [0.1, 0.1, 0]", 10, "each entry of environment.part.vertices must have 3 numbers, not 2"),
    ("[0.2, 0, 0], [0.1, 0.1, 0]", "[0.2, 0, 0, 0], [0.1, 0.1, 0]", 10, "each entry of environment.part.vertices must have 3 numbers, not 4"),
    ("[0.2, 0, 0], [0.1, 0.1, 0]", "0.2, [0.1, 0.1, 0]", 10, "each entry of environment.part.vertices must be a list of 3 numbers, not a number"),
    ("[0.2, 0, 0], [0.1, 0.1, 0]", "[0.2, nan, 0], [0.1, 0.1, 0]", 10, "environment.part.vertices: nan must lie between -1000 and 1000 m"),
    ("[0.2, 0, 0], [0.1, 0.1, 0]", "[0.2, 0, 1e300], [0.1, 0.1, 0]", 10, "environment.part.vertices: 1e300 must lie between -1000 and 1000 m"),
    ("[0.2, 0, 0], [0.1, 0.1, 0]", "[0.2, '0', 0], [0.1, 0.1, 0]", 10, "environment.part.vertices: '0' must be a number, not text in quotes"),
    ("[0.2, 0, 0], [0.1, 0.1, 0]", "[0.2, 0, 0] [0.1, 0.1, 0]", 10, "a comma or the closing bracket `]` of a list is missing"),
    ("[0.2, 0, 0], [0.1, 0.1, 0]", "[0.2, 0, 0,, ], [0.1, 0.1, 0]", 10, "a value is missing before this comma"),
    ("position = [0.1, 0.0, 0.0]", "position = [0.1, 0.0]", 11, "environment.part.position must have 3 numbers, not 2"),
    ("position = [0.1, 0.0, 0.0]", "position = [0.1, 0.0, 0.0, 9]", 11, "environment.part.position must have 3 numbers, not 4"),
    ("position = [0.1, 0.0, 0.0]", "position = [0.1, 0.0, 1001]", 11, "environment.part.position: 1001 must lie between -1000 and 1000 m"),
    ("position = [0.1, 0.0, 0.0]", "position = 0.1", 11, "environment.part.position must be a list of 3 numbers, not a number"),
    ("orientation = [1, 0, 0, 0]\n[[env", "orientation = [1, 0, 0]\n[[env", 12, "environment.part.orientation must have 4 numbers, not 3"),
    ("orientation = [1, 0, 0, 0]\n[[env", "orientation = [1, 0, 0, 0, 0]\n[[env", 12, "environment.part.orientation must have 4 numbers, not 5"),
    ("orientation = [1, 0, 0, 0]\n[[env", "orientation = [1, 1, 0, 0]\n[[env", 12, "environment.part.orientation: a quaternion [w, x, y, z] has norm 1, this one has norm 1.4142"),
    ("orientation = [1, 0, 0, 0]\n[[env", "orientation = [0, 0, 0, 0]\n[[env", 12, "environment.part.orientation: a quaternion [w, x, y, z] has norm 1, this one has norm 0.0000"),
    ("orientation = [1, 0, 0, 0]\n[[env", "orientation = [nan, 0, 0, 0]\n[[env", 12, "environment.part.orientation: nan must lie between -1000 and 1000"),
    ("orientation = [1, 0, 0, 0]\n[[env", "orientation = [1e300, 0, 0, 0]\n[[env", 12, "environment.part.orientation: 1e300 must lie between -1000 and 1000"),
    ("normals = [[1, 0, 0],", "normals = [[0, 0, 0],", 15, "environment.part.normals: the normal is shorter than 1e-6"),
    ("normals = [[1, 0, 0],", "normals = [[1, 0, 0, 0],", 15, "each entry of environment.part.normals must have 3 numbers, not 4"),
    ("normals = [[1, 0, 0],", "normals = [", 15, "part `floor`: 5 normals but 6 offsets"),
    ("normals = [[1, 0, 0],", "normals = [[1e-300, 0, 0],", 15, "environment.part.normals: the normal is shorter than 1e-6"),
    ("normals = [[1, 0, 0],", "normals = [[0, 1, 0],", 15, "part `floor`: the halfspaces do not bound the part in direction (1.000, 0.000, 0.000)"),
    ("normals = [[1, 0, 0],", "normals = [[1, 0, inf],", 15, "environment.part.normals: inf must lie between -1e6 and 1e6"),
    ("offsets = [0.5, 0.5, 0.5, 0.5, 0, 0.1]\n", "", 15, "part `floor` needs both `normals` and `offsets`"),
    ("offsets = [0.5, 0.5, 0.5, 0.5, 0, 0.1]", "offsets = [0.5, 0.5, 0.5, 0.5, 0]", 15, "part `floor`: 6 normals but 5 offsets"),
    ("offsets = [0.5, 0.5, 0.5, 0.5, 0, 0.1]", "offsets = [0.5, 0.5, 0.5, 0.5, 0, -0.1]", 15, "part `floor`: the halfspaces have no common interior"),
    ("offsets = [0.5, 0.5, 0.5, 0.5, 0, 0.1]", "offsets = [0.5, 0.5, 0.5, 0.5, 0, 2e4]", 15, "part `floor`: a corner is more than 10000 m from the origin along an axis"),
    ("offsets = [0.5, 0.5, 0.5, 0.5, 0, 0.1]", "offsets = [0.5, 0.5, 0.5, 0.5, 0, nan]", 16, "environment.part.offsets: nan must lie between -1e9 and 1e9 m"),
    ("offsets = [0.5, 0.5, 0.5, 0.5, 0, 0.1]", "offsets = 0.5", 16, "environment.part.offsets = 0.5: must be a list, not a number"),
    ("offsets = [0.5, 0.5, 0.5, 0.5, 0, 0.1]", "offsets = [[0.5], 0.5, 0.5, 0.5, 0, 0.1]", 16, "environment.part.offsets: [0.5] must be a number, not a list"),
    ("normals = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]\n", "", 15, "part `floor` needs both `normals` and `offsets`"),
    ("[contact]", "[contacts]", 17, "unknown key `contacts`, did you mean `contact`?"),
    ("[contact]", "[[contact]]", 17, "contact is a single table: write [contact], not [[contact]]"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pairs = []", 18, "contact.pairs has 0 entries: it must have at least 1"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pairs = ['shaft', 'wall']", 18, "each entry of contact.pairs must be a list of 2 names, not text in quotes"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pairs = [['shaft', 'wall', 'floor']]", 18, "each entry of contact.pairs must have 2 names, not 3"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pairs = [['shaft']]", 18, "each entry of contact.pairs must have 2 names, not 1"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pairs = [['shaft', 1]]", 18, "contact.pairs: 1 must be text in quotes, not a number"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pairs = [['wall', 'shaft']]", 18, "[body] has no part `wall`; valid are: shaft"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pairs = [['shaft', 'wal']]", 18, "[environment] has no part `wal`, did you mean `wall`?"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pairs = [['shaft', 'wall'], ['shaft', 'wall']]", 18, "the pair `shaft`, `wall` is listed twice"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pairs = 'all'", 18, "contact.pairs = 'all': must be a list, not text in quotes"),
    ("pairs = [['shaft', 'wall'], ['shaft', 'floor']]", "pair = [['shaft', 'wall']]", 18, "unknown key `pair`, did you mean `pairs`?"),
    ("[[start]]\n", "[start]\n", 19, "there may be several: write [[start]], not [start]"),
    ("[[start]]\nname = 'a'\nposition = [0, 0, 0.09]\norientation = [1, 0, 0, 0]\n", "", 0, "the scene has no [[start]]: poses to start from; the first is the default"),
    ("[[start]]\nname = 'a'\nposition = [0, 0, 0.09]\norientation = [1, 0, 0, 0]\n[goal", "[goal", 0, "the scene has no [[start]]: poses to start from; the first is the default"),
    ("title = 'base'", "start = []\ntitle = 'base'", 20, "`start` is given twice"),
    ("position = [0, 0, 0.09]", "position = [0, 0, 0.06]", 21, "start `a` is the goal: there is nothing to plan; move it to where the motion begins"),
    ("name = 'a'\n", "", 19, "missing key `name` in [[start]]: unique name of the start, for `--start`"),
    ("name = 'a'", "name = ''", 20, "start.name is empty: 1 to 100 characters are needed"),
    ("name = 'a'", "name = \"a\\r\\nb\"", 20, "start.name must not contain line breaks or control characters"),
    ("name = 'a'\nposition = [0, 0, 0.09]", "name = 'a'", 19, "missing key `position` in [[start]]: position of the body's frame in the world (m)"),
    ("position = [0, 0, 0.09]", "position = [0, 0, 0.09, 9]", 21, "start.position must have 3 numbers, not 4"),
    ("position = [0, 0, 0.09]", "position = [0, 0, '0.09']", 21, "start.position: '0.09' must be a number, not text in quotes"),
    ("position = [0, 0, 0.09]", "position = [0, 0, 90000]", 21, "start.position: 90000 must lie between -1000 and 1000 m"),
    ("position = [0, 0, 0.09]", "position = [0, 0, 90]\nposition = [0, 0, 0.09]", 22, "`position` is given twice"),
    ("position = [0, 0, 0.09]", "pos = [0, 0, 0.09]", 21, "unknown key `pos`, did you mean `position`?"),
    ("orientation = [1, 0, 0, 0]\n[goal]", "orientation = [1, 0, 0, 0, 0]\n[goal]", 22, "start.orientation must have 4 numbers, not 5"),
    ("orientation = [1, 0, 0, 0]\n[goal]", "orientation = [0.9, 0, 0, 0]\n[goal]", 22, "start.orientation: a quaternion [w, x, y, z] has norm 1, this one has norm 0.9000"),
    ("orientation = [1, 0, 0, 0]\n[goal]", "orientation = [1, 0, 0, 0]\n[[start]]\nname = 'a'\nposition = [0, 0, 0.1]\norientation = [1, 0, 0, 0]\n[goal]", 24, "start name `a` is used twice"),
    ("[goal]\nposition = [0, 0, 0.06]\norientation = [1, 0, 0, 0]\n", "", 0, "the scene has no [goal]: pose of the body at the end"),
    ("[goal]", "[[goal]]", 23, "goal is a single table: write [goal], not [[goal]]"),
    ("[goal]", "[gaol]", 23, "unknown key `gaol`, did you mean `goal`?"),
    ("[goal]", "[goal]\nname = 'g'", 24, "unknown key `name`; valid are: position, orientation"),
    ("position = [0, 0, 0.06]\n", "", 23, "missing key `position` in [goal]: position of the body's frame in the world (m)"),
    ("position = [0, 0, 0.06]", "position = [0, 0]", 24, "goal.position must have 3 numbers, not 2"),
    ("position = [0, 0, 0.06]", "position = [1e300, 0, 0]", 24, "goal.position: 1e300 must lie between -1000 and 1000 m"),
    ("orientation = [1, 0, 0, 0]\n[imp", "orientation = [0.7, 0.7, 0, 0]\n[imp", 25, "goal.orientation: a quaternion [w, x, y, z] has norm 1, this one has norm 0.9899"),
    ("orientation = [1, 0, 0, 0]\n[imp", "[imp", 23, "missing key `orientation` in [goal]: orientation of the body's frame in the world"),
    ("[impedance]", "[impedence]", 26, "unknown key `impedence`, did you mean `impedance`?"),
    ("translational_stiffness = 50.0", "translational_stiffness = 0", 27, "impedance.translational_stiffness = 0: must lie between 0.001 and 1e7 N/m"),
    ("translational_stiffness = 50.0", "translational_stiffness = 1e8", 27, "impedance.translational_stiffness = 1e8: must lie between 0.001 and 1e7 N/m"),
    ("translational_stiffness = 50.0", "translational_stiffness = [50, 50, 50]", 27, "impedance.translational_stiffness must be a number, not a list"),
    ("rotational_stiffness = 5.0", "rotational_stiffness = '5'", 28, "impedance.rotational_stiffness = '5': must be a number, not text in quotes"),
    ("rotational_stiffness = 5.0", "rotational_stiffness = -5", 28, "impedance.rotational_stiffness = -5: must lie between 0.001 and 1e7 Nm/rad"),
    ("rotational_stiffness = 5.0", "rotational_stifness = 5", 28, "unknown key `rotational_stifness`, did you mean `rotational_stiffness`?"),
    ("translational_damping = 14.0", "translational_damping = -14", 29, "impedance.translational_damping = -14: must lie between 0 and 1e7 Ns/m"),
    ("translational_damping = 14.0", "translational_damping = [1, 2]", 29, "impedance.translational_damping must be a number, 3 numbers or a 3x3 matrix, not 2 numbers"),
    ("translational_damping = 14.0", "translational_damping = '14'", 29, "impedance.translational_damping = '14': must be a number, 3 numbers or a 3x3 matrix, not text in quotes"),
    ("translational_damping = 14.0", "translational_damping = [1, 2, -3]", 29, "impedance.translational_damping: -3 must lie between 0 and 1e7 Ns/m"),
    ("translational_damping = 14.0", "translational_damping = [[1, 1, 0], [0, 1, 0], [0, 0, 1]]", 29, "impedance.translational_damping must be symmetric (Ns/m)"),
    ("translational_damping = 14.0", "translational_damping = [[1, 2, 0], [2, 1, 0], [0, 0, 1]]", 29, "impedance.translational_damping must be positive semidefinite, with principal values between 0 and 1e7 Ns/m; one is -1.0e0"),
    ("translational_damping = 14.0", "translational_damping = [[1e7, 1, 0], [1, 1e7, 0], [0, 0, 1]]", 29, "impedance.translational_damping must be positive semidefinite, with principal values between 0 and 1e7 Ns/m; one is 1.0e7"),
    ("rotational_damping = [1.4, 1.4, 1.4]", "rotational_damping = 1.4", 30, "impedance.rotational_damping = 1.4: must be 3 numbers or a 3x3 matrix, not a number"),
    ("rotational_damping = [1.4, 1.4, 1.4]", "rotational_damping = [1.4, 1.4]", 30, "impedance.rotational_damping must be 3 numbers or a 3x3 matrix, not 2 numbers"),
    ("rotational_damping = [1.4, 1.4, 1.4]", "rotational_damping = [1.4, 1.4, -1]", 30, "impedance.rotational_damping: -1 must lie between 0 and 1e7 Nms/rad"),
    ("rotational_damping = [1.4, 1.4, 1.4]", "rotational_damping = [1.4, 1.4, 1e8]", 30, "impedance.rotational_damping: 1e8 must lie between 0 and 1e7 Nms/rad"),
    ("rotational_damping = [1.4, 1.4, 1.4]", "rotational_damping = [[1, 0, 0], [0, 1, 0], [0, 0, -1e-3]]", 30, "impedance.rotational_damping must be positive semidefinite, with principal values between 0 and 1e7 Nms/rad; one is -1.0e-3"),
    ("[robustness]", "[robustnes]", 31, "unknown key `robustnes`, did you mean `robustness`?"),
    ("offset_magnitude = 0.02", "offset_magnitude = -0.02", 32, "robustness.offset_magnitude = -0.02: must lie between 0 and 10 m"),
    ("offset_magnitude = 0.02", "offset_magnitude = 20", 32, "robustness.offset_magnitude = 20: must lie between 0 and 10 m"),
    ("offset_magnitude = 0.02", "offset_magnitude = nan", 32, "robustness.offset_magnitude = nan: must lie between 0 and 10 m"),
    ("offset_magnitude = 0.02", "offset_magnitude = '2 cm'", 32, "robustness.offset_magnitude = '2 cm': must be a number, not text in quotes"),
    ("offset_magnitude = 0.02\n", "", 31, "missing key `offset_magnitude` in [robustness]: how far the body may be from where the robot believes it to be: a radius (m)"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = []", 33, "robustness.offset_directions has 0 entries: it must have at least 1"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [0.6, -0.8, 0]", 33, "each entry of robustness.offset_directions must be a list of 3 numbers, not a number"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [[0.6, -0.8]]", 33, "each entry of robustness.offset_directions must have 3 numbers, not 2"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [[0.5, 0, 0]]", 33, "robustness.offset_directions: a direction has norm 1, or is [0, 0, 0]; this one has norm 0.5000"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [[1e-200, 0, 0]]", 33, "robustness.offset_directions: a direction has norm 1, or is [0, 0, 0]; this one has norm 0.0000"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [[inf, 0, 0]]", 33, "robustness.offset_directions: inf must lie between -1000 and 1000"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = 'all'", 33, "robustness.offset_directions = 'all': must be a list, not text in quotes"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [[0.6, -0.8, 0]]\nrotation_axes = [[1, 0, 0], [0, 1, 0]]", 34, "robustness.rotation_axes has 2 axes: give one for each of the 1 offset_directions"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [[0.6, -0.8, 0]]\nrotation_axes = [[1, 1, 0]]", 34, "robustness.rotation_axes: a direction has norm 1, or is [0, 0, 0]; this one has norm 1.4142"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [[0.6, -0.8, 0]]\ncoverage = 'disc'", 34, "robustness.coverage beside robustness.offset_directions: directions cover their hull; leave one of the two keys out"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [[0.6, -0.8, 0]]\ninsertion_axis = [0, 0, 1]", 34, "robustness.insertion_axis beside robustness.offset_directions: directions cover their hull"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "coverage = 'ball'\ninsertion_axis = [0, 0, 1]", 34, "robustness.insertion_axis beside robustness.coverage = \"ball\": a ball has no axis"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "coverage = 'disk'", 33, "robustness.coverage: unknown value `disk`, did you mean `disc`?"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "coverage = ['disc']", 33, "robustness.coverage must be one of \"disc\", \"ball\", not a list"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "insertion_axis = [0, 0, 2]", 33, "robustness.insertion_axis: a direction has norm 1; this one has norm 2.0000"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "insertion_axis = [0, 0]", 33, "robustness.insertion_axis must have 3 numbers, not 2"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "rotation_axes = [[1, 0, 0]]", 33, "robustness.rotation_axes without robustness.offset_directions: give a direction for each of the axes"),
    ("steps = 10", "steps = 0", 35, "horizon.steps = 0: must lie between 1 and 10000"),
    ("steps = 10", "steps = -1", 35, "horizon.steps = -1: must lie between 1 and 10000"),
    ("steps = 10", "steps = 10.0", 35, "horizon.steps = 10.0: must be an integer"),
    ("steps = 10", "steps = 2.5", 35, "horizon.steps = 2.5: must be an integer"),
    ("steps = 10", "steps = 10001", 35, "horizon.steps = 10001: must lie between 1 and 10000"),
    ("steps = 10", "steps = 1e3", 35, "horizon.steps = 1e3: must be an integer"),
    ("steps = 10", "steps = 99999999999999999999", 35, "horizon.steps = 99999999999999999999: must lie between 1 and 10000"),
    ("steps = 10", "steps = '10'", 35, "horizon.steps = '10': must be an integer, not text in quotes"),
    ("steps = 10", "steps = [10]", 35, "horizon.steps must be an integer, not a list"),
    ("steps = 10", "stepps = 10", 35, "unknown key `stepps`, did you mean `steps`?"),
    ("time_step = 0.04", "time_step = 0", 36, "horizon.time_step = 0: must lie between 1e-5 and 10 s"),
    ("time_step = 0.04", "time_step = 1e-6", 36, "horizon.time_step = 1e-6: must lie between 1e-5 and 10 s"),
    ("time_step = 0.04", "time_step = 11", 36, "horizon.time_step = 11: must lie between 1e-5 and 10 s"),
    ("time_step = 0.04", "time_step = 1e-300", 36, "horizon.time_step = 1e-300: must lie between 1e-5 and 10 s"),
    ("time_step = 0.04", "dt = 0.04", 36, "unknown key `dt`; valid are: steps, time_step"),
    ("[cost]", "[costs]", 37, "unknown key `costs`, did you mean `cost`?"),
    ("reference = { translational_velocity = 1,", "reference = { translational_velocity = -1,", 38, "cost.reference.translational_velocity = -1: must lie between 0 and 1e12"),
    ("reference = { translational_velocity = 1,", "reference = { translational_velocity = 1e13,", 38, "cost.reference.translational_velocity = 1e13: must lie between 0 and 1e12"),
    ("reference = { translational_velocity = 1,", "reference = { velocity = 1,", 38, "unknown key `velocity`; valid are: translational_velocity, rotational_velocity, terminal_position, terminal_orientation"),
    ("reference = { translational_velocity = 1,", "reference = { translational_velocity = '1',", 38, "cost.reference.translational_velocity = '1': must be a number, not text in quotes"),
    ("reference = { translational_velocity = 1,", "reference = { translational_velocity = 1", 38, "a comma or the closing brace `}` of a table is missing"),
    ("reference = { translational_velocity = 1, terminal_position = 100 }", "reference = 1", 38, "cost.reference = 1: must be a table, not a number"),
    ("reference = { translational_velocity = 1, terminal_position = 100 }", "reference = { terminal_position = 1, terminal_position = 2 }", 38, "`terminal_position` is given twice"),
    ("reference = { translational_velocity = 1, terminal_position = 100 }", "reference = [1, 2]", 38, "cost.reference must be a table, not a list"),
    ("compliant = {", "complaint = {", 39, "unknown key `complaint`, did you mean `compliant`?"),
    ("[limits]", "[limit]", 40, "unknown key `limit`, did you mean `limits`?"),
    ("torque = 1.0", "torque = 0", 42, "limits.torque = 0: must lie between 1e-9 and 1e9 Nm"),
    ("torque = 1.0", "torque = 1e10", 42, "limits.torque = 1e10: must lie between 1e-9 and 1e9 Nm"),
    ("torque = 1.0", "torques = 1", 42, "unknown key `torques`, did you mean `torque`?"),
    ("torque = 1.0", "torque = [1, 1, 1]", 42, "limits.torque must be a number, not a list"),
    ("translational_velocity = 1.0\n", "translational_velocity = 0.01\n", 41, "limits.translational_velocity = 0.01: the goal is 0.030 m from start `a` along an axis, and 10 steps of 0.04 s"),
    ("steps = 10\ntime_step = 0.04", "steps = 10000\ntime_step = 0.04\n[x", 37, "the closing bracket `]` of a header is missing"),
    ("title = 'base'", "title = 'a' 'b'", 1, "the line must end here; decimals are written with a point"),
    ("title = 'base'", "title = \"\\q\"", 1, "a backslash is written `\\\\`, or the text is put in single quotes"),
    ("title = 'base'", "title = 'base';", 1, "the line must end here; decimals are written with a point"),
    ("title = 'base'", "title = \"C:\\parts\"", 1, "a backslash is written `\\\\`, or the text is put in single quotes"),
    ("mass = 1.0", "mass = 1_000_000_000", 3, "body.mass = 1_000_000_000: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = 'heavy'", 3, "body.mass = 'heavy': must be a number, not text in quotes"),
    ("mass = 1.0", "mass = 0b", 3, "body.mass = 0b: must lie between 1e-6 and 1e6 kg"),
    ("mass = 1.0", "mass = +-1", 3, "a number has one sign at most"),
    ("mass = 1.0", "Mass = 1.0", 3, "unknown key `Mass`, did you mean `mass`?"),
    ("mass = 1.0", "part = 1", 5, "`part` is given twice"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[0.1, 0.1, 0.1]]", 4, "body.inertia must have 3 rows, not 1"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[1, 0, 0], [0, inf, 0], [0, 0, 1]]", 4, "body.inertia: inf must lie between -1e6 and 1e6 kg m^2"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [[1, 0, 0], [0, 1, 0], [0, 0, '1']]", 4, "body.inertia: '1' must be a number, not text in quotes"),
    ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, 0.1, true]", 4, "body.inertia: true must be a number, not true or false"),
    ("box = [0.02, 0.02, 0.1]", "box = []", 7, "body.part.box must have 3 numbers, not 0"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02; 0.02; 0.1]", 7, "`0.02; 0.02; 0.1` is not a number; units are left out, and lists need commas"),
    ("box = [0.02, 0.02, 0.1]", "box = [20mm, 20mm, 100mm]", 7, "`20mm` is not a number; units are left out, and lists need commas"),
    ("box = [0.02, 0.02, 0.1]", "offsets = [1, 1, 1, 1]", 7, "part `shaft` needs both `normals` and `offsets`"),
    ("box = [0.02, 0.02, 0.1]", "box = (0.02, 0.02, 0.1)", 7, "the line must end here; decimals are written with a point"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02, 0.02, 0.1]\nmass = 1", 8, "unknown key `mass` here: it belongs to [body]"),
    ("box = [0.02, 0.02, 0.1]", "box = [0.02, 0.02, 0.1]\nscale = 1", 8, "unknown key `scale`"),
    ("position = [0.1, 0.0, 0.0]", "position = []", 11, "environment.part.position must have 3 numbers, not 0"),
    ("position = [0.1, 0.0, 0.0]", "position = { x = 0.1 }", 11, "environment.part.position must be a list of 3 numbers, not a table"),
    ("position = [0.1, 0.0, 0.0]", "position = [false, 0, 0]", 11, "environment.part.position: false must be a number, not true or false"),
    ("position = [0, 0, 0.09]", "position = '0 0 0.09'", 21, "start.position must be a list of 3 numbers, not text in quotes"),
    ("position = [0, 0, 0.09]", "position = [0, 0, -1e4]", 21, "start.position: -1e4 must lie between -1000 and 1000 m"),
    ("position = [0, 0, 0.06]", "position = [0, 0, 0.06, 0]", 24, "goal.position must have 3 numbers, not 4"),
    ("position = [0, 0, 0.06]", "position = [0, 0, 'up']", 24, "goal.position: 'up' must be a number, not text in quotes"),
    ("offset_magnitude = 0.02", "offset_magnitude = [0.02]", 32, "robustness.offset_magnitude must be a number, not a list"),
    ("offset_magnitude = 0.02", "offset = 0.02", 32, "unknown key `offset`, did you mean `offset_magnitude`?"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [[0.6, -0.8, 0, 0]]", 33, "each entry of robustness.offset_directions must have 3 numbers, not 4"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "offset_directions = [['x', 0, 0]]", 33, "robustness.offset_directions: 'x' must be a number, not text in quotes"),
    ("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", "directions = [[1, 0, 0]]", 33, "unknown key `directions`, did you mean `offset_directions`?"),
    ("time_step = 0.04", "time_step = '0.04'", 36, "horizon.time_step = '0.04': must be a number, not text in quotes"),
    ("time_step = 0.04", "time_step = nan", 36, "horizon.time_step = nan: must lie between 1e-5 and 10 s"),
    ("time_step = 0.04", "time_step = 0.04 s", 36, "`0.04 s` is not a number; units are left out, and lists need commas"),
    ("time_step = 0.04", "timestep = 0.04", 36, "unknown key `timestep`, did you mean `time_step`?"),
    ("translational_velocity = 1.0\n", "velocity = 1.0\n", 41, "unknown key `velocity`; valid are: translational_velocity, rotational_velocity, translational_acceleration, ro"),
    ("torque = 1.0", "torque = inf", 42, "limits.torque = inf: must lie between 1e-9 and 1e9 Nm"),
    ("torque = 1.0", "torque = true", 42, "limits.torque = true: must be a number, not true or false"),
    ("torque = 1.0", "moment = 1.0", 42, "unknown key `moment`; valid are: translational_velocity, rotational_velocity, translational_acceleration, rota"),
    ("[limits]", "[[limits]]", 40, "limits is a single table: write [limits], not [[limits]]"),
    ("[cost]", "[[cost]]", 37, "cost is a single table: write [cost], not [[cost]]"),
    ("[cost]", "[cost.reference]", 38, "unknown key `reference` here: it belongs to [cost]"),
    ("compliant = {", "reference = {", 39, "`reference` is given twice"),
    ("[horizon]", "[[horizon]]", 34, "horizon is a single table: write [horizon], not [[horizon]]"),
    ("[horizon]", "[horizont]", 34, "unknown key `horizont`, did you mean `horizon`?"),
    ("[robustness]", "[[robustness]]", 31, "robustness is a single table: write [robustness], not [[robustness]]"),
    ("[impedance]", "[[impedance]]", 26, "impedance is a single table: write [impedance], not [[impedance]]"),
    ("[impedance]", "[impedance", 26, "the closing bracket `]` of a header is missing"),
    ("[start]]", "[start]", 19, "the closing brackets `]]` of a header are missing"),
    ("[[start]]", "[[starts]]", 19, "unknown key `starts`, did you mean `start`?"),
    ("[goal]", "[start.goal]", 23, "unknown key `goal`; valid are: name, position, orientation"),
    ("[environment", "[[environment", 8, "a key is missing"),
    ("[contact]", "[contact]\nadhesion = 0.3", 18, "unknown key `adhesion`; valid are: pairs, friction"),
    ("[contact]", "[contact]\nfriction = -0.1", 18, "contact.friction = -0.1"),
    ("[contact]", "[contact]\nfriction = 2.1", 18, "contact.friction = 2.1"),
    ("[contact]", "[contact]\nfriction = [0, 2.1]", 18, "contact.friction: 2.1 must lie between 0 and 2"),
    ("[contact]", "[contact]\nfriction = []", 18, "contact.friction"),
];

#[test]
fn the_scene_that_the_cases_change_is_right() {
    let scene = parse(BASE).unwrap_or_else(|error| panic!("{error}"));
    assert!(scene.warnings.is_empty());
}

#[test]
fn every_wrong_scene_is_refused_at_its_line_with_its_words() {
    for (from, to, line, words) in CASES {
        assert!(BASE.contains(from), "{from}");
        let text = BASE.replacen(from, to, 1);
        let Err(error) = parse(&text) else { panic!("`{to}` is accepted") };
        assert!(error.message().contains(words), "{to}\n{error}");
        assert_eq!(error.line().unwrap_or(0), *line, "{to}\n{error}");
        assert!(error.to_string().starts_with("test.toml:"), "{error}");
    }
}

#[test]
fn no_message_is_in_the_words_of_the_parser() {
    for (from, to, ..) in CASES {
        let message = parse(&BASE.replacen(from, to, 1)).unwrap_err().message().to_owned();
        for jargon in
            ["invalid type", "expected", "did not match", "untagged", "f64", "i64", "usize", "struct", "field"]
        {
            assert!(!message.contains(jargon), "{message}");
        }
    }
}
