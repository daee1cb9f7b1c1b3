//! A rendered scene as SVG, for small pictures and where there is no GPU: the same quads as `render::gpu` draws,
//! their figures a little simpler. One unit is one cell; inside a figure x and y run from −1 to 1, y up, as
//! in the shader.

use crate::domain::Color;
use crate::render::{Extent, Figure, Quad, Rgba, Scene};
use yew::{Html, html};

/// What a picture shows, as an SVG view box.
pub(crate) fn view_box(extent: &Extent) -> String {
    let top = f64::from(extent.bottom) + f64::from(extent.rows) - 0.5;
    let left = f64::from(extent.left) - 0.5;
    format!("{left} {} {} {}", -top, extent.columns, extent.rows)
}

/// All quads of a scene, from back to front.
pub(crate) fn quads(scene: &Scene) -> Html {
    html! { <>{ for scene.quads.iter().map(quad) }</> }
}

fn quad(quad: &Quad) -> Html {
    match quad.figure {
        Figure::Frame | Figure::Dashes => rect(quad, Some(quad.detail[1])),
        Figure::Grid => grid(quad),
        Figure::Region => figure(quad, region(quad)),
        Figure::Arrow => figure(quad, arrow(quad)),
        Figure::Padlock | Figure::Question => icon(quad, badge),
        Figure::Robot => icon(quad, robot),
        Figure::Chair => icon(quad, chair),
        Figure::Basket => icon(quad, basket),
        Figure::Block => icon(quad, block),
        Figure::Bag => icon(quad, bag),
        Figure::Backpack => icon(quad, backpack),
        Figure::Box => icon(quad, crate_box),
        Figure::Letter => letter(quad),
        Figure::Rect | Figure::Floor => rect(quad, None),
    }
}

fn css(colour: Rgba) -> String {
    let [r, g, b, a] = colour.0.map(f64::from);
    let byte = |c: f64| (c * 255.0).round();
    format!("rgb({} {} {} / {a:.3})", byte(r), byte(g), byte(b))
}

fn rect(quad: &Quad, line: Option<f32>) -> Html {
    let ([x, y], [w, h]) = (quad.centre, quad.half);
    // A blurred edge is drawn as a paler, sharp one.
    let blurred = quad.figure == Figure::Rect && quad.detail[1] > 0.0;
    let fade = if blurred { "0.6" } else { "1" };
    html! {
        <rect x={(x - w).to_string()} y={(-y - h).to_string()} width={(2.0 * w).to_string()}
            height={(2.0 * h).to_string()} rx={quad.detail[0].to_string()} fill={css(quad.fill)} opacity={fade}
            stroke={line.map(|_| css(quad.ink))} stroke-width={line.map(|l| l.to_string())}
            stroke-dasharray={(quad.figure == Figure::Dashes).then_some(".15 .1")} />
    }
}

fn grid(quad: &Quad) -> Html {
    let ([x, y], [w, h]) = (quad.centre, quad.half);
    let mut d = String::new();
    let mut line = x - w + 1.0;
    while line < x + w - 0.5 {
        d.push_str(&format!("M{line} {}V{}", -y - h, -y + h));
        line += 1.0;
    }
    line = -y - h + 1.0;
    while line < -y + h - 0.5 {
        d.push_str(&format!("M{} {line}H{}", x - w, x + w));
        line += 1.0;
    }
    html! { <path d={d} fill="none" stroke={css(quad.ink)} stroke-width=".03" /> }
}

fn badge(quad: &Quad) -> Html {
    let sign = if quad.figure == Figure::Padlock {
        "M-.43 .11h.86v-.62h-.86zM-.27 .1v.1a.27 .27 0 0 0 .54 0v-.1h-.14v.1a.13 .13 0 0 1-.26 0v-.1z"
    } else {
        "M-.3 .25a.3 .3 0 0 1 .6 0c0 .3-.2 .2-.2 .5h-.2c0-.45 .2-.4 .2-.5a.1 .1 0 0 0-.2 0zM-.1-.35h.2v-.2h-.2z"
    };
    html! {
        <><circle r=".93" fill={css(quad.fill)} /><path d={sign} fill={css(quad.ink)} stroke="none" /></>
    }
}

/// A cell's part of a region: a tint, stripes, and a line where the region ends.
fn region(quad: &Quad) -> Html {
    let ends = if quad.detail[1] > 0.0 { 0.84 } else { 0.9 };
    let belongs = |bit: u8| quad.detail[0] as u8 & bit != 0;
    let reach = |bit: u8| if belongs(bit) { 1.0 } else { ends };
    let [north, east, south, west] = [reach(1), reach(2), -reach(4), -reach(8)];
    let mut line = String::new();
    for (open, path) in [
        (!belongs(1), format!("M{west} {north}H{east}")),
        (!belongs(2), format!("M{east} {north}V{south}")),
        (!belongs(4), format!("M{west} {south}H{east}")),
        (!belongs(8), format!("M{west} {north}V{south}")),
    ] {
        line.push_str(if open { &path } else { "" });
    }
    for (beside, across, x, y) in [(3, 16, 1, 1), (6, 32, 1, -1), (12, 64, -1, -1), (9, 128, -1, 1)]
    {
        if quad.detail[0] as u8 & beside == beside && !belongs(across) {
            let inner = |sign: i32| f64::from(sign) * ends;
            line.push_str(&format!("M{x} {}H{}V{y}", inner(y), inner(x)));
        }
    }
    let mut stripes = String::new();
    for k in -8..8 {
        // A stripe runs where x + y is so much; the quad is two units wide.
        let sum = (f64::from(k) + 0.5) * 2.0 * f64::from(quad.detail[1]);
        let (from, to) = (west.max(sum - north), east.min(sum - south));
        if quad.detail[1] > 0.0 && from < to {
            stripes.push_str(&format!("M{from} {}L{to} {}", sum - from, sum - to));
        }
    }
    html! {
        <>
            <path d={format!("M{west} {south}V{north}H{east}V{south}z")} fill={css(quad.fill)} stroke="none" />
            <path d={stripes + &line} fill="none" stroke-linecap="round" />
        </>
    }
}

fn arrow(quad: &Quad) -> Html {
    let around = "M0-.58A.58 .58 0 1 1-.58 0M-.92 .14L-.58-.2-.24 .14";
    let (d, mirror) = match quad.detail[0] as u8 {
        0 => ("M0-.75V.7M-.52 .16L0 .72 .52 .16", None),
        1 => (around, None),
        2 => (around, Some("scale(-1 1)")),
        _ => ("M0-.66V.66M-.42 .32L0 .78 .42 .32M-.42-.32L0-.78 .42-.32", None),
    };
    html! { <path d={d} transform={mirror} fill="none" stroke={css(quad.fill)} stroke-width=".3" stroke-linecap="round" /> }
}

fn letter(quad: &Quad) -> Html {
    let ([x, y], [w, _]) = (quad.centre, quad.half);
    let sign = Color::ALL.get(quad.detail[0] as usize).map_or(' ', |color| color.letter());
    html! {
        <>
            <circle cx={x.to_string()} cy={(-y).to_string()} r={w.to_string()} fill={css(quad.fill)} />
            <text class="letter" x={x.to_string()} y={(-y).to_string()} font-size={(1.7 * w).to_string()}
                fill={css(quad.ink)} aria-hidden="true">{ sign.to_ascii_uppercase() }</text>
        </>
    }
}

/// A thing, as transparent as its fill.
fn icon(quad: &Quad, parts: fn(&Quad) -> Html) -> Html {
    let Rgba([.., opacity]) = quad.fill;
    let opaque = Quad { fill: quad.fill.alpha(1.0), ink: quad.ink.alpha(1.0), ..*quad };
    html! { <g opacity={(opacity < 1.0).then(|| opacity.to_string())}>{ figure(&opaque, parts(&opaque)) }</g> }
}

/// Parts in the figure's own square, outlined in ink.
fn figure(quad: &Quad, parts: Html) -> Html {
    let ([x, y], [w, h]) = (quad.centre, quad.half);
    let turn = -quad.turn.to_degrees();
    html! {
        <g transform={format!("translate({x} {}) rotate({turn}) scale({w} {})", -y, -h)}
            stroke={css(quad.ink)} stroke-width=".09" stroke-linejoin="round">{ parts }</g>
    }
}

/// Outlined paths, each with its colour.
fn paths<const N: usize>(parts: [(&'static str, Rgba); N]) -> Html {
    html! { <>{ for parts.into_iter().map(|(d, fill)| html! { <path d={d} fill={css(fill)} /> }) }</> }
}

fn light(quad: &Quad) -> Rgba {
    quad.fill.mix(Rgba([1.0; 4]), 0.34)
}

fn dark(quad: &Quad) -> Rgba {
    quad.fill.mix(quad.ink, 0.36)
}

fn robot(quad: &Quad) -> Html {
    let accent = "rgb(41 189 219)";
    html! {
        <>
            <path d="M-.91 .38h.3v-.84h-.3zM.61 .38h.3v-.84h-.3z" fill={css(quad.ink.mix(quad.fill, 0.25))} />
            <path d="M-.42 .55L0 1.03 .42 .55z" fill={accent} />
            <circle r=".75" fill={css(quad.fill)} />
            <rect x="-.5" y=".01" width="1" height=".52" rx=".24" fill={css(quad.ink)} stroke="none" />
            <circle cx="-.22" cy=".3" r=".115" fill={accent} stroke="none" />
            <circle cx=".22" cy=".3" r=".115" fill={accent} stroke="none" />
        </>
    }
}

fn chair(quad: &Quad) -> Html {
    paths([
        (
            "M-.6 .9h.2v-1.1h-.2zM.4 .9h.2v-1.1h-.2zM-.7-.2h.24v-.76h-.24zM.46-.2h.24v-.76h-.24z",
            dark(quad),
        ),
        ("M-.62 .92h1.24v-.34h-1.24zM-.48 .4h.96v-.22h-.96z", quad.fill),
        ("M-.78-.02h1.56v-.36h-1.56z", light(quad)),
    ])
}

fn basket(quad: &Quad) -> Html {
    paths([
        ("M-.8 .1a.8 .76 0 0 0 1.6 0h-.2a.6 .56 0 0 1-1.2 0z", dark(quad)),
        ("M-.86 .08h1.72l-.26-1h-1.2z", quad.fill),
        ("M-.96 .25h1.92v-.3h-1.92z", light(quad)),
    ])
}

fn block(quad: &Quad) -> Html {
    paths([
        ("M-.86 .44L0-.05v-.92l-.86 .49z", quad.fill),
        ("M.86 .44L0-.05v-.92l.86 .49z", dark(quad)),
        ("M0-.05L-.86 .44 0 .93 .86 .44z", light(quad)),
    ])
}

fn bag(quad: &Quad) -> Html {
    paths([
        ("M-.44 .94h.88l-.3-.5h-.28z", dark(quad)),
        (
            "M-.22 .44h.44c.1-.3 .58-.3 .58-.82 0-.4-.3-.56-.8-.56s-.8 .16-.8 .56c0 .52 .48 .52 .58 .82z",
            quad.fill,
        ),
        ("M-.34 .53h.68v-.22h-.68z", light(quad)),
    ])
}

fn backpack(quad: &Quad) -> Html {
    paths([
        ("M-.26 .7a.26 .26 0 0 0 .52 0zM-.9 0h1.8v-.78h-1.8z", dark(quad)),
        ("M-.66-.94h1.32v1.12a.66 .56 0 0 1-1.32 0z", quad.fill),
        ("M-.44-.24h.88v-.56h-.88z", light(quad)),
    ])
}

fn crate_box(quad: &Quad) -> Html {
    paths([
        ("M-.7 .4l-.24 .46h.3l.16-.46zM.7 .4l.24 .46h-.3l-.16-.46z", light(quad)),
        ("M-.64 .62h1.28v-.3h-1.28z", dark(quad).mix(quad.ink, 0.5)),
        ("M-.8 .38h1.6v-1.32h-1.6z", quad.fill),
        ("M-.13 .36h.26v-.38h-.26z", light(quad)),
    ])
}
