// A picture in one draw call: every instance is a quad, and the fragment shader draws the quad's figure from
// signed distances (negative inside) in units of half the quad, with edges smoothed over one device pixel.
// Colours are sRGB and blended as such. The figures' numbers are those of `quad.rs`.

struct Camera {
    // The lower left corner that is shown, in cells, and cells → clip space.
    corner: vec2f,
    scale: vec2f,
    // The offset in clip space, device pixels a cell, unused.
    offset: vec2f,
    pixels: f32,
    unused: f32,
}

@group(0) @binding(0) var<uniform> camera: Camera;

struct Instance {
    @location(0) place: vec4f,  // centre, half size, in cells
    @location(1) form: vec4f,   // turn, figure, detail
    @location(2) fill: vec4f,
    @location(3) ink: vec4f,
}

struct Varying {
    @builtin(position) position: vec4f,
    @location(0) at: vec2f,     // from the quad's centre, in cells, before it is turned
    @location(1) @interpolate(flat) half: vec2f,
    @location(2) @interpolate(flat) form: vec4f,
    @location(3) @interpolate(flat) fill: vec4f,
    @location(4) @interpolate(flat) ink: vec4f,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32, quad: Instance) -> Varying {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
    // Room for the smoothed edge, and for the blur of a soft rectangle.
    let blur = select(0.0, quad.form.w, quad.form.y == 0.0);
    let at = corner * (quad.place.zw + blur + 1.5 / camera.pixels);
    let c = cos(quad.form.x);
    let s = sin(quad.form.x);
    let world = quad.place.xy + vec2f(c * at.x - s * at.y, s * at.x + c * at.y);
    var out: Varying;
    out.position = vec4f((world - camera.corner) * camera.scale + camera.offset, 0.0, 1.0);
    out.at = at;
    out.half = quad.place.zw;
    out.form = quad.form;
    out.fill = quad.fill;
    out.ink = quad.ink;
    return out;
}

// Signed distances.

fn disc(p: vec2f, r: f32) -> f32 {
    return length(p) - r;
}

fn rectangle(p: vec2f, half: vec2f, corner: f32) -> f32 {
    let q = abs(p) - half + corner;
    return length(max(q, vec2f(0.0))) + min(max(q.x, q.y), 0.0) - corner;
}

fn bar(p: vec2f, a: vec2f, b: vec2f, r: f32) -> f32 {
    let along = b - a;
    let t = clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    return length(p - a - along * t) - r;
}

// Upright, symmetric: half widths below and above. Exact at its sides, which is what shows.
fn trapezoid(p: vec2f, below: f32, above: f32, h: f32) -> f32 {
    let side = normalize(vec2f(2.0 * h, below - above));
    return max(dot(vec2f(abs(p.x) - below, p.y + h), side), abs(p.y) - h);
}

fn ring(p: vec2f, r: f32, thick: f32) -> f32 {
    return abs(length(p) - r) - thick;
}

fn joined(a: f32, b: f32, soft: f32) -> f32 {
    let h = max(soft - abs(a - b), 0.0) / soft;
    return min(a, b) - h * h * soft * 0.25;
}

// A cell's part of a region that ends `reach` from the cell's middle where a neighbour does not belong to it. Each
// quadrant looks at the neighbour beside it, the one above or below it, and the one across.
fn region(p: vec2f, neighbours: u32, reach: f32, corner: f32) -> f32 {
    let east = p.x > 0.0;
    let north = p.y > 0.0;
    let beside = (neighbours & select(8u, 2u, east)) != 0u;
    let above = (neighbours & select(4u, 1u, north)) != 0u;
    let across = (neighbours & select(select(64u, 32u, east), select(128u, 16u, east), north)) != 0u;
    let q = abs(p) - reach;
    if beside && above {
        let hole = corner - q;
        let outside = length(max(hole, vec2f(0.0))) + min(max(hole.x, hole.y), 0.0) - corner;
        return select(-outside, -reach, across);
    }
    if beside { return q.y; }
    if above { return q.x; }
    return rectangle(p, vec2f(reach), corner);
}

// The forms of `ArrowForm`.
fn arrow(p: vec2f, form: u32) -> f32 {
    if form == 0u {
        let head = bar(vec2f(abs(p.x), p.y), vec2f(0.0, 0.72), vec2f(0.52, 0.16), 0.15);
        return min(head, bar(p, vec2f(0.0, -0.75), vec2f(0.0, 0.6), 0.15));
    }
    if form == 3u {
        let head = bar(abs(p), vec2f(0.0, 0.78), vec2f(0.42, 0.32), 0.15);
        return min(head, bar(abs(p), vec2f(0.0), vec2f(0.0, 0.66), 0.15));
    }
    // Three quarters of a ring, ending in the west with a head that points south.
    let q = vec2f(select(p.x, -p.x, form == 2u), p.y);
    let arc = max(ring(q, 0.58, 0.14), -max(q.x, q.y));
    let head = vec2f(abs(q.x + 0.58), q.y);
    return min(arc, bar(head, vec2f(0.0, -0.2), vec2f(0.34, 0.14), 0.14));
}

// A picture in the making: premultiplied colour so far, and what its parts are drawn with.

struct Brush {
    colour: vec4f,
    ink: vec3f,
    pixel: f32,   // a device pixel, in the figure's units
    line: f32,    // width of an outline
}

fn cover(brush: Brush, d: f32) -> f32 {
    return clamp(0.5 - d / brush.pixel, 0.0, 1.0);
}

fn flat_part(brush: Brush, d: f32, colour: vec3f) -> Brush {
    var next = brush;
    let a = cover(brush, d);
    next.colour = vec4f(colour * a, a) + brush.colour * (1.0 - a);
    return next;
}

fn part(brush: Brush, d: f32, colour: vec3f) -> Brush {
    return flat_part(flat_part(brush, d, brush.ink), d + brush.line, colour);
}

fn robot(brush: Brush, p: vec2f, shell: vec3f) -> Brush {
    let side = vec2f(abs(p.x), p.y);
    let accent = vec3f(0.16, 0.74, 0.86);
    var b = part(brush, rectangle(side - vec2f(0.76, -0.04), vec2f(0.15, 0.42), 0.1), mix(brush.ink, shell, 0.25));
    // A nose that points ahead.
    let nose = max(trapezoid(p - vec2f(0.0, 0.73), 0.42, 0.03, 0.24), -p.y);
    b = part(b, nose - 0.05, accent);
    b = part(b, disc(p, 0.78), shell);
    b = flat_part(b, max(disc(p, 0.78 - b.line), -disc(p - vec2f(-0.1, 0.14), 0.76)), mix(shell, brush.ink, 0.13));
    b = flat_part(b, rectangle(p - vec2f(0.0, 0.27), vec2f(0.5, 0.26), 0.24), brush.ink);
    b = flat_part(b, disc(side - vec2f(0.22, 0.3), 0.115), accent);
    return flat_part(b, rectangle(p - vec2f(0.0, -0.36), vec2f(0.24, 0.055), 0.05), mix(shell, brush.ink, 0.35));
}

fn chair(brush: Brush, p: vec2f, c: vec3f, light: vec3f, dark: vec3f) -> Brush {
    let side = vec2f(abs(p.x), p.y);
    var b = part(brush, rectangle(side - vec2f(0.5, 0.4), vec2f(0.13, 0.58), 0.09), dark);
    b = part(b, rectangle(p - vec2f(0.0, 0.76), vec2f(0.64, 0.2), 0.12), c);
    b = part(b, rectangle(p - vec2f(0.0, 0.3), vec2f(0.5, 0.13), 0.05), c);
    b = part(b, rectangle(side - vec2f(0.58, -0.6), vec2f(0.13, 0.4), 0.06), dark);
    return part(b, rectangle(p - vec2f(0.0, -0.2), vec2f(0.8, 0.2), 0.12), light);
}

fn basket(brush: Brush, p: vec2f, c: vec3f, light: vec3f, dark: vec3f) -> Brush {
    let arch = vec2f(p.x, (p.y - 0.06) * 0.92);
    var b = part(brush, max(ring(arch, 0.72, 0.11), -arch.y), dark);
    let body = trapezoid(p - vec2f(0.0, -0.42), 0.58, 0.84, 0.5) - 0.05;
    b = part(b, body, c);
    // Weave: staves set against each other from row to row.
    let row = floor((p.y + 0.93) / 0.3);
    let x = (fract((p.x + 0.17 * (row % 2.0)) / 0.34) - 0.5) * 0.34;
    let y = (fract((p.y + 0.93) / 0.3) - 0.5) * 0.3;
    let stave = rectangle(vec2f(x, y), vec2f(0.1, 0.085), 0.04);
    b = flat_part(b, max(stave, body + 2.0 * b.line), dark);
    return part(b, rectangle(p - vec2f(0.0, 0.1), vec2f(0.98, 0.17), 0.12), light);
}

fn block(brush: Brush, p: vec2f, c: vec3f, light: vec3f, dark: vec3f) -> Brush {
    // A cube seen from its corner: edges fall by half a unit over 0.88.
    let k = normalize(vec2f(0.5, 0.88));
    let x = abs(p.x);
    let lid = dot(vec2f(x, abs(p.y - 0.45)), k) - 0.5 * k.y;
    let rise = x * 0.5 / 0.88;
    let low = max(max(p.y + 0.05 - rise, rise - 0.95 - p.y) * k.y, x - 0.88);
    var b = flat_part(brush, min(low, lid), brush.ink);
    let seam = b.line * 0.5;
    b = flat_part(b, max(low + b.line, p.x + seam), c);
    b = flat_part(b, max(low + b.line, seam - p.x), dark);
    return flat_part(b, lid + b.line, light);
}

fn bag(brush: Brush, p: vec2f, c: vec3f, light: vec3f, dark: vec3f) -> Brush {
    var b = part(brush, trapezoid(p - vec2f(0.0, 0.7), 0.16, 0.46, 0.24) - 0.05, dark);
    let round = rectangle(p - vec2f(0.0, -0.38), vec2f(0.8, 0.58), 0.52);
    let body = joined(round, trapezoid(p - vec2f(0.0, 0.2), 0.34, 0.2, 0.24), 0.35);
    b = part(b, body, c);
    let fold = bar(p, vec2f(-0.42, -0.05), vec2f(-0.5, -0.42), 0.07);
    b = flat_part(b, fold, light);
    b = flat_part(b, bar(vec2f(abs(p.x), p.y), vec2f(0.1, 0.3), vec2f(0.2, 0.02), 0.035), dark);
    return part(b, rectangle(p - vec2f(0.0, 0.42), vec2f(0.36, 0.13), 0.11), light);
}

fn backpack(brush: Brush, p: vec2f, c: vec3f, light: vec3f, dark: vec3f) -> Brush {
    let side = vec2f(abs(p.x), p.y);
    var b = part(brush, ring(p - vec2f(0.0, 0.72), 0.19, 0.09), dark);
    b = part(b, rectangle(side - vec2f(0.72, -0.4), vec2f(0.2, 0.4), 0.16), dark);
    let dome = rectangle(p - vec2f(0.0, -0.1), vec2f(0.68, 0.86), select(0.2, 0.6, p.y > -0.1));
    b = part(b, dome, c);
    b = flat_part(b, max(abs(p.y - 0.16) - 0.045, dome + 0.16), brush.ink);
    b = flat_part(b, rectangle(p - vec2f(0.26, 0.06), vec2f(0.06, 0.13), 0.05), light);
    b = part(b, rectangle(p - vec2f(0.0, -0.52), vec2f(0.46, 0.3), 0.14), light);
    return flat_part(b, rectangle(p - vec2f(0.0, -0.37), vec2f(0.3, 0.035), 0.03), dark);
}

fn crate_box(brush: Brush, p: vec2f, c: vec3f, light: vec3f, dark: vec3f) -> Brush {
    let side = vec2f(abs(p.x), p.y);
    // Flaps that stand open, the dark inside, the front with its label.
    var b = part(brush, bar(side, vec2f(0.62, 0.42), vec2f(0.86, 0.78), 0.13), light);
    b = part(b, rectangle(p - vec2f(0.0, 0.4), vec2f(0.66, 0.24), 0.04), mix(dark, brush.ink, 0.55));
    b = part(b, rectangle(p - vec2f(0.0, -0.28), vec2f(0.8, 0.68), 0.08), c);
    b = flat_part(b, rectangle(p - vec2f(0.0, 0.18), vec2f(0.14, 0.2 - b.line), 0.0), light);
    return flat_part(b, rectangle(p - vec2f(0.3, -0.62), vec2f(0.28, 0.13), 0.03), dark);
}

fn padlock(brush: Brush, p: vec2f, c: vec3f) -> Brush {
    var b = flat_part(brush, disc(p, 1.0), brush.ink);
    b = flat_part(b, disc(p, 0.86), c);
    let arch = p - vec2f(0.0, 0.16);
    let shackle = min(max(ring(arch, 0.27, 0.085), -arch.y), rectangle(vec2f(abs(p.x) - 0.27, p.y - 0.08), vec2f(0.085, 0.12), 0.0));
    b = flat_part(b, shackle, brush.ink);
    b = flat_part(b, rectangle(p - vec2f(0.0, -0.2), vec2f(0.43, 0.31), 0.09), brush.ink);
    return flat_part(b, bar(p, vec2f(0.0, -0.13), vec2f(0.0, -0.27), 0.07), c);
}

fn question(brush: Brush, p: vec2f, c: vec3f) -> Brush {
    var b = flat_part(brush, disc(p, 1.0), brush.ink);
    b = flat_part(b, disc(p, 0.86), c);
    let head = p - vec2f(0.0, 0.22);
    let hook = max(ring(head, 0.26, 0.1), min(-head.x, -head.y));
    let sign = min(min(hook, bar(p, vec2f(0.0, -0.04), vec2f(0.0, -0.18), 0.1)), disc(p - vec2f(0.0, -0.5), 0.13));
    return flat_part(b, sign, brush.ink);
}

// Half a ring to the right of a stem, with the two bars that lead to it: the bowl of B and R.
fn bowl(p: vec2f, middle: f32, r: f32) -> f32 {
    let side = vec2f(p.x, abs(p.y - middle));
    let leads = bar(side, vec2f(-0.4, r), vec2f(0.46 - r, r), 0.13);
    let turn = side - vec2f(0.46 - r, 0.0);
    return min(leads, max(ring(turn, r, 0.13), -turn.x));
}

// The letters of the nine colours, in the order of the table: R G B Y M N O T E.
fn letter(p: vec2f, which: u32) -> f32 {
    let side = vec2f(abs(p.x), p.y);
    let left = bar(p, vec2f(-0.4, -0.78), vec2f(-0.4, 0.78), 0.13);
    let round = ring(vec2f(p.x, p.y * 0.74), 0.58, 0.13);
    switch which {
        case 0u: { return min(min(left, bowl(p, 0.39, 0.39)), bar(p, vec2f(0.02, 0.0), vec2f(0.42, -0.78), 0.13)); }
        case 1u: {
            let gap = max(round, -max(0.05 - p.x, abs(p.y - 0.16) - 0.26));
            return min(gap, min(bar(p, vec2f(0.12, -0.1), vec2f(0.58, -0.1), 0.13), bar(p, vec2f(0.58, -0.1), vec2f(0.58, -0.34), 0.13)));
        }
        case 2u: { return min(min(left, bowl(p, 0.38, 0.4)), bowl(p - vec2f(0.06, 0.0), -0.38, 0.4)); }
        case 3u: { return min(bar(side, vec2f(0.0, 0.0), vec2f(0.5, 0.78), 0.13), bar(p, vec2f(0.0, 0.0), vec2f(0.0, -0.78), 0.13)); }
        case 4u: { return min(bar(side, vec2f(0.58, -0.78), vec2f(0.58, 0.78), 0.13), bar(side, vec2f(0.0, -0.1), vec2f(0.58, 0.78), 0.13)); }
        case 5u: { return min(bar(side, vec2f(0.46, -0.78), vec2f(0.46, 0.78), 0.13), bar(p, vec2f(-0.46, 0.78), vec2f(0.46, -0.78), 0.13)); }
        case 6u: { return round; }
        case 7u: { return min(bar(p, vec2f(-0.5, 0.78), vec2f(0.5, 0.78), 0.13), bar(p, vec2f(0.0, -0.78), vec2f(0.0, 0.78), 0.13)); }
        default: { return min(min(left, bar(vec2f(p.x, abs(p.y)), vec2f(-0.4, 0.78), vec2f(0.42, 0.78), 0.13)), bar(p, vec2f(-0.4, 0.0), vec2f(0.3, 0.0), 0.13)); }
    }
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4f {
    let cell = 1.0 / camera.pixels;
    let figure = u32(in.form.y + 0.5);
    let fill = vec4f(in.fill.rgb * in.fill.a, in.fill.a);
    let ink = vec4f(in.ink.rgb * in.ink.a, in.ink.a);
    if figure == 0u {
        let d = rectangle(in.at, in.half, min(in.form.z, min(in.half.x, in.half.y)));
        let soft = max(in.form.w, cell * 0.5);
        let t = clamp(0.5 - d / (2.0 * soft), 0.0, 1.0);
        // A straight ramp for a pixel's edge, a rounded one for a shadow.
        return fill * select(t, t * t * (3.0 - 2.0 * t), in.form.w > 0.0);
    }
    if figure == 1u {
        let d = rectangle(in.at, in.half, in.form.z);
        let line = max(in.form.w, 1.5 * cell);
        let inside = clamp(0.5 - d / cell, 0.0, 1.0);
        let within = clamp(0.5 - (d + line) / cell, 0.0, 1.0);
        return ink * (inside - within) + fill * within;
    }
    if figure == 2u {
        let p = in.at + in.half + 0.5;
        let near = abs(p - round(p)) - 0.5 * max(0.03, cell);
        // A wall's middle is the quad's edge: the first line is one and a half cells further in.
        let inside = step(vec2f(1.0), in.half - abs(in.at));
        let on = clamp(0.5 - near / cell, vec2f(0.0), vec2f(1.0)) * inside;
        return ink * max(on.x, on.y);
    }
    if figure == 3u {
        // Light comes from the north-west: the shade under the northern and western wall reaches further.
        let reach = select(vec2f(0.35), vec2f(1.0), vec2f(-in.at.x, in.at.y) > vec2f(0.0)) * in.form.w;
        let free = clamp((in.half - in.form.z - abs(in.at)) / reach, vec2f(0.0), vec2f(1.0));
        let shade = 1.0 - (1.0 - (1.0 - free.x) * (1.0 - free.x)) * (1.0 - (1.0 - free.y) * (1.0 - free.y));
        return vec4f(mix(in.fill.rgb, in.ink.rgb, in.ink.a * shade), 1.0) * in.fill.a;
    }
    if figure == 14u {
        // What lies beyond the cell is its neighbours' to draw.
        if any(in.at < -in.half) || any(in.at >= in.half) { return vec4f(0.0); }
        let striped = in.form.w > 0.0;
        let d = region(in.at, u32(in.form.z + 0.5), select(0.45, 0.42, striped), 0.14);
        let line = max(0.055, 1.5 * cell);
        let inside = clamp(0.5 - d / cell, 0.0, 1.0);
        let within = clamp(0.5 - (d + line) / cell, 0.0, 1.0);
        let pitch = max(in.form.w, 0.01);
        let off = abs(fract((in.at.x + in.at.y) / pitch) - 0.5) * pitch * 0.7071;
        let stripe = within * select(0.0, clamp(0.5 - (off - 0.028) / cell, 0.0, 1.0), striped);
        let on = inside - within + stripe;
        return ink * on + fill * within * (1.0 - ink.a * stripe);
    }
    if figure == 16u {
        let d = rectangle(in.at, in.half, in.form.z);
        let line = max(in.form.w, 1.5 * cell);
        let side = abs(in.at) - in.half;
        let along = select(in.at.x, in.at.y, side.x > side.y);
        let dash = abs(fract(along * 4.0 + 0.5) - 0.5) * 0.25 - 0.075;
        let on = clamp(0.5 - d / cell, 0.0, 1.0) - clamp(0.5 - (d + line) / cell, 0.0, 1.0);
        return ink * on * clamp(0.5 - dash / cell, 0.0, 1.0);
    }
    let unit = 1.0 / in.half.y;
    if figure == 15u {
        return fill * clamp(0.5 - arrow(in.at * unit, u32(in.form.z + 0.5)) / (cell * unit), 0.0, 1.0);
    }
    var brush: Brush;
    brush.ink = in.ink.rgb;
    brush.pixel = cell * unit;
    brush.line = max(0.085, 1.2 * brush.pixel);
    let p = in.at * unit;
    if figure == 13u {
        let disc_here = fill * cover(brush, disc(p, 1.0));
        let sign = ink * cover(brush, letter(p / mix(0.95, 0.62, in.fill.a), u32(in.form.z + 0.5)));
        return sign + disc_here * (1.0 - sign.a);
    }
    let c = in.fill.rgb;
    let light = mix(c, vec3f(1.0), 0.34);
    let dark = mix(c, brush.ink, 0.36);
    switch figure {
        case 4u: { brush = padlock(brush, p, c); }
        case 5u: { brush = question(brush, p, c); }
        case 6u: { brush = robot(brush, p, c); }
        case 7u: { brush = chair(brush, p, c, light, dark); }
        case 8u: { brush = basket(brush, p, c, light, dark); }
        case 9u: { brush = block(brush, p, c, light, dark); }
        case 10u: { brush = bag(brush, p, c, light, dark); }
        case 11u: { brush = backpack(brush, p, c, light, dark); }
        default: { brush = crate_box(brush, p, c, light, dark); }
    }
    return brush.colour * in.fill.a;
}
