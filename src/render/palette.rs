//! The colours of a picture, in a light and a dark theme. Values are sRGB as in CSS (the canvas blends in sRGB,
//! so that picture and page agree); contrast is WCAG 2's ratio of relative luminances, 1 to 21.
//! Invariant, tested: every object stands out from every floor by a contrast of 3, by its fill or its outline.

use crate::domain::Color;

/// A colour: sRGB components and opacity, each in 0..=1, not premultiplied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rgba(pub [f32; 4]);

/// Which of the two sets of colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Dark things on pale floors.
    #[default]
    Light,
    /// Bright things on deep floors.
    Dark,
}

impl Rgba {
    /// From `0xRRGGBB`, opaque.
    pub const fn hex(rgb: u32) -> Self {
        let [_, r, g, b] = rgb.to_be_bytes();
        Self([r as f32 / 255.0, g as f32 / 255.0, b as f32 / 255.0, 1.0])
    }

    /// The same colour at another opacity.
    pub const fn alpha(self, opacity: f32) -> Self {
        let [r, g, b, _] = self.0;
        Self([r, g, b, opacity])
    }

    /// The colour `t` of the way to `other`, in sRGB.
    pub fn mix(self, other: Self, t: f32) -> Self {
        let mut mixed = self.0;
        for (mine, theirs) in mixed.iter_mut().zip(other.0) {
            *mine += (theirs - *mine) * t;
        }
        Self(mixed)
    }

    /// The components in linear light (IEC 61966-2-1); opacity unchanged.
    pub fn linear(self) -> [f32; 4] {
        let open = |c: f32| {
            if c <= 0.04045 { c / 12.92 } else { libm::powf((c + 0.055) / 1.055, 2.4) }
        };
        let [r, g, b, a] = self.0;
        [open(r), open(g), open(b), a]
    }

    /// Relative luminance (WCAG 2), 0 to 1.
    pub fn luminance(self) -> f32 {
        let [r, g, b, _] = self.linear();
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    /// Contrast with another colour (WCAG 2), 1 to 21.
    pub fn contrast(self, other: Self) -> f32 {
        let (a, b) = (self.luminance() + 0.05, other.luminance() + 0.05);
        if a > b { a / b } else { b / a }
    }

    /// Nearly black or white, whichever is seen on this. Brightness is weighed without leaving sRGB, which is near
    /// enough for two colours so far apart, and cheap enough for every cell of a frame.
    pub fn opposite(self) -> Self {
        let [r, g, b, _] = self.0;
        let bright = 0.299 * r + 0.587 * g + 0.114 * b > 0.46;
        Self::hex(if bright { 0x14161b } else { 0xffffff })
    }
}

impl Theme {
    const fn pick(self, light: u32, dark: u32) -> Rgba {
        Rgba::hex(match self {
            Self::Light => light,
            Self::Dark => dark,
        })
    }

    /// What lies around the rooms: the page's own ground.
    pub const fn backdrop(self) -> Rgba {
        self.pick(0xf7f6f3, 0x14161b)
    }

    /// The body of a wall.
    pub const fn wall(self) -> Rgba {
        self.pick(0x4b5262, 0x6f7a90)
    }

    /// The floor of a doorway.
    pub const fn sill(self) -> Rgba {
        self.pick(0xe9e5dc, 0x2a2e37)
    }

    /// The leaf of a door, and its badge, by what is known of its lock.
    pub const fn open_leaf(self) -> Rgba {
        self.pick(0x8a93a6, 0xb9c2d3)
    }

    /// A door that nobody has tried.
    pub const fn unknown_leaf(self) -> Rgba {
        self.pick(0xc98a10, 0xe9b347)
    }

    /// A door that does not open.
    pub const fn locked_leaf(self) -> Rgba {
        self.pick(0xb3362f, 0xe8695f)
    }

    /// What is drawn upon a badge.
    pub const fn on_badge(self) -> Rgba {
        self.pick(0xffffff, 0x14161b)
    }

    /// Lines between cells.
    pub const fn grid(self) -> Rgba {
        self.pick(0x2b3040, 0xdfe5f2).alpha(match self {
            Self::Light => 0.085,
            Self::Dark => 0.075,
        })
    }

    /// What falls from things onto the floor.
    pub const fn shadow(self) -> Rgba {
        Rgba::hex(0x0b0d14).alpha(match self {
            Self::Light => 0.26,
            Self::Dark => 0.5,
        })
    }

    /// Letters.
    pub const fn signs(self) -> Rgba {
        self.pick(0x23262f, 0xf1f3f8)
    }

    /// Outlines and inner lines of objects.
    pub const fn ink(self) -> Rgba {
        self.pick(0x23262f, 0x0c0e12)
    }

    /// The robot's shell.
    pub const fn robot(self) -> Rgba {
        self.pick(0xf4f6fa, 0xe9edf5)
    }

    /// The robot's face, which shows where it looks.
    pub const fn robot_face(self) -> Rgba {
        self.pick(0x2b3242, 0x202634)
    }

    /// Frame and tint of cells that are pointed out.
    pub const fn highlight(self) -> Rgba {
        self.pick(0x6a4df4, 0xb3a4ff)
    }

    /// What is not allowed.
    pub const fn refused(self) -> Rgba {
        self.locked_leaf()
    }

    /// The ground of cells where a goal holds: to be seen on a floor and on any value, with its stripes.
    pub const fn goal(self) -> Rgba {
        self.backdrop().alpha(0.62)
    }

    /// The stripes of cells where a goal holds.
    pub const fn goal_stripes(self) -> Rgba {
        self.signs().alpha(0.5)
    }

    /// The colours of values from 0 to 1 in even steps, for a legend: away from the ground by even steps of
    /// lightness, so that the order is seen without seeing hues.
    pub fn value_stops(self) -> [Rgba; 5] {
        match self {
            Self::Light => [0xfbf6d9, 0xc8e3b0, 0x8bcaa3, 0x4aaca9, 0x1f86a8],
            Self::Dark => [0x24265c, 0x2a5080, 0x2b7f8c, 0x5ab08a, 0xcfe08a],
        }
        .map(Rgba::hex)
    }

    /// The colour of a value in 0..=1.
    pub fn value(self, value: f32) -> Rgba {
        let stops = self.value_stops();
        let at = unit(value) * (stops.len() - 1) as f32;
        let below = at as usize;
        let low = stops[below];
        stops.get(below + 1).map_or(low, |high| low.mix(*high, at - below as f32))
    }

    /// An object's colour.
    pub const fn object(self, color: Color) -> Rgba {
        match color {
            Color::Red => self.pick(0xdd4339, 0xf0655c),
            Color::Green => self.pick(0x3fa052, 0x5cc070),
            Color::Blue => self.pick(0x3a78db, 0x639bf2),
            Color::Yellow => self.pick(0xf6c92f, 0xf8d557),
            Color::Magenta => self.pick(0xc940b4, 0xe26bd0),
            Color::Brown => self.pick(0x87553a, 0xb98362),
            Color::Orange => self.pick(0xf08526, 0xf99b4a),
            Color::Tan => self.pick(0xd8bd90, 0xdfc9a4),
            Color::Teal => self.pick(0x179a95, 0x3cbcb5),
        }
    }

    /// A room's floor: the same hue, quiet.
    pub const fn floor(self, color: Color) -> Rgba {
        match color {
            Color::Red => self.pick(0xf6cbc6, 0x4e2a2b),
            Color::Green => self.pick(0xcbe6cc, 0x24402c),
            Color::Blue => self.pick(0xc8dbf7, 0x25395c),
            Color::Yellow => self.pick(0xfbeca9, 0x4c431d),
            Color::Magenta => self.pick(0xf0cdec, 0x47284a),
            Color::Brown => self.pick(0xddc3b1, 0x3d2c23),
            Color::Orange => self.pick(0xfbd7b0, 0x553519),
            Color::Tan => self.pick(0xefe5d1, 0x423b30),
            Color::Teal => self.pick(0xbfe5e1, 0x1c4343),
        }
    }
}

/// A number cut to 0..=1; 0 for what is none.
pub(super) fn unit(value: f32) -> f32 {
    if value > 0.0 { value.min(1.0) } else { 0.0 }
}
