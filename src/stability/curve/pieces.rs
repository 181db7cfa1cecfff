//! Pieces of a boundary along each of which one thing crosses.

use super::{
    Boundary, Crossing, CurveKind,
    geometry::{between, length, mixed},
    trace::{ON_EDGE, Spot, Tracer},
};

/// A piece of a boundary along which one thing crosses.
pub(super) struct Branch {
    pub spots: Vec<Spot>,
    /// \[Hz\]
    pub frequency: Vec<f64>,
    pub kind: CurveKind,
    pub closed: bool,
    pub bounds: bool,
}

/// All branches in the unit square, within `tolerance` of straight lines between their spots.
pub(super) fn branches(boundary: &dyn Boundary, tolerance: f64) -> Vec<Branch> {
    let mut all = Vec::new();
    for kind in CurveKind::BOTH {
        let tracer = Tracer { boundary, kind, tolerance };
        for trace in tracer.traces() {
            tracer.cut(&trace, &mut all);
        }
    }
    all
}

impl Tracer<'_> {
    /// Adds the parts of a curve along each of which one thing crosses.
    fn cut(&self, trace: &[Spot], pieces: &mut Vec<Branch>) {
        let crossing = |spot: &Spot| self.boundary.crossing(self.kind, spot.at);
        let same = |a: Option<Crossing>, b: Option<Crossing>| a.map(|a| a.bounds) == b.map(|b| b.bounds);
        let first = pieces.len();
        let mut piece = self.empty();
        let mut last: Option<(Spot, Option<Crossing>)> = None;
        for spot in trace.iter().copied().map(on_edge) {
            let here = (spot, crossing(&spot));
            if let Some(before) = last.filter(|before| !same(before.1, here.1)) {
                let (mut low, mut high) = (before, here);
                for _ in 0..40 {
                    let reach = length(between(low.0.at, high.0.at));
                    let Some(spot) = self.spot(mixed(low.0.at, high.0.at, 0.5), reach) else { break };
                    let middle = (spot, crossing(&spot));
                    *(if same(middle.1, low.1) { &mut low } else { &mut high }) = middle;
                }
                piece.push((on_edge(low.0), low.1));
                piece.finish(pieces);
                piece = self.empty();
                piece.push((on_edge(high.0), high.1));
            }
            piece.push(here);
            last = Some(here);
        }
        piece.finish(pieces);
        if trace.len() < 3 || trace.first() != trace.last() {
            return;
        }
        match &mut pieces[first..] {
            [whole] if whole.spots.len() == trace.len() => whole.closed = true,
            // The one that ends where the curve was begun goes on with the one that begins there.
            [.., last] if last.spots.last() == trace.last() => {
                last.spots.pop();
                last.frequency.pop();
                if let Some(mut last) = pieces.pop() {
                    last.spots.append(&mut pieces[first].spots);
                    last.frequency.append(&mut pieces[first].frequency);
                    pieces[first] = last;
                }
            }
            _ => {}
        }
    }

    fn empty(&self) -> Branch {
        Branch { spots: Vec::new(), frequency: Vec::new(), kind: self.kind, closed: false, bounds: false }
    }
}

impl Branch {
    /// Goes on to a spot, if something crosses there.
    #[inline(never)]
    fn push(&mut self, (spot, crossing): (Spot, Option<Crossing>)) {
        if let Some(Crossing { frequency, bounds }) = crossing {
            self.spots.push(spot);
            self.frequency.push(frequency);
            self.bounds = bounds;
        }
    }

    /// Adds it to others, if it has any length.
    #[inline(never)]
    fn finish(self, pieces: &mut Vec<Branch>) {
        if self.spots.len() > 1 {
            pieces.push(self);
        }
    }
}

/// What is next to an edge is on it.
fn on_edge(mut spot: Spot) -> Spot {
    for part in &mut spot.at {
        for edge in [0.0, 1.0] {
            if (*part - edge).abs() <= ON_EDGE {
                *part = edge;
            }
        }
    }
    spot
}

#[cfg(test)]
mod tests {
    use super::super::{Point, geometry::cross};
    use super::*;

    /// A boundary given by functions.
    struct Given {
        test: fn(Point) -> (f64, Point),
        crossing: fn(Point) -> Option<Crossing>,
        seeds: Vec<[Point; 2]>,
    }

    impl Boundary for Given {
        fn test(&self, _: CurveKind, at: Point) -> (f64, Point) {
            (self.test)(at)
        }

        fn seeds(&self, kind: CurveKind) -> Vec<[Point; 2]> {
            if kind == CurveKind::Hopf { self.seeds.clone() } else { Vec::new() }
        }

        fn crossing(&self, _: CurveKind, at: Point) -> Option<Crossing> {
            (self.crossing)(at)
        }

        fn holds(&self, _: CurveKind, at: Point) -> bool {
            (self.test)(at).0.abs() < 1e-9
        }

        fn stable(&self, at: Point) -> bool {
            (self.test)(at).0 > 0.0
        }
    }

    /// Positive within a circle of radius 0.3 about the middle.
    fn circle([x, y]: Point) -> (f64, Point) {
        let (x, y) = (x - 0.5, y - 0.5);
        (0.09 - x * x - y * y, [-2.0 * x, -2.0 * y])
    }

    fn always(_: Point) -> Option<Crossing> {
        Some(Crossing { frequency: 1.0, bounds: true })
    }

    const ACROSS: [Point; 2] = [[0.5, 0.5], [0.9, 0.5]];

    #[test]
    fn a_circle_closes_and_is_not_far_from_its_chords() {
        for tolerance in [1e-3, 1e-4, 1e-5] {
            let seeds = vec![ACROSS, [[0.5, 0.5], [0.5, 0.9]], [[0.2, 0.5]; 2]];
            let [whole] = &branches(&Given { test: circle, crossing: always, seeds }, tolerance)[..] else { panic!() };
            assert!(whole.closed && whole.bounds && whole.spots.first() == whole.spots.last());
            let mut turned = 0.0;
            for two in whole.spots.windows(2) {
                let middle = mixed(two[0].at, two[1].at, 0.5);
                let height = 0.3 - length(between([0.5; 2], middle));
                assert!(height < tolerance && (length(between([0.5; 2], two[0].at)) - 0.3).abs() < 1e-12, "{height}");
                turned += cross(two[0].tangent, two[1].tangent).asin();
            }
            // Its inside is at its left: once round against the clock.
            assert!((turned / std::f64::consts::TAU - 1.0).abs() < 1e-9, "{turned}");
        }
    }

    #[test]
    fn it_is_cut_where_what_crosses_changes() {
        // To the right of 0.6 nothing crosses, above the middle something else is beyond the axis.
        let crossing = |[x, y]: Point| (x < 0.6).then_some(Crossing { frequency: x, bounds: y < 0.5 });
        let pieces = branches(&Given { test: circle, crossing, seeds: vec![ACROSS] }, 1e-4);
        let [above, below] = &pieces[..] else { panic!("{} pieces", pieces.len()) };
        let upper = 0.5 + (0.09_f64 - 0.01).sqrt();
        assert!(!above.bounds && below.bounds && !above.closed && !below.closed);
        let ends = |piece: &Branch| [piece.spots[0].at, piece.spots[piece.spots.len() - 1].at];
        for (got, expected) in
            ends(above).into_iter().chain(ends(below)).zip([[0.6, upper], [0.2, 0.5], [0.2, 0.5], [0.6, 1.0 - upper]])
        {
            assert!(length(between(got, expected)) < 1e-9, "{got:?} {expected:?}");
        }
        for piece in &pieces {
            assert!(piece.spots.iter().zip(&piece.frequency).all(|(spot, frequency)| spot.at[0] == *frequency));
        }
    }

    #[test]
    fn a_closed_curve_that_is_cut_once_on_its_way_stays_one() {
        // The seed lies where something crosses, so that the curve is begun within the one piece there is.
        let crossing = |[x, _]: Point| (x > 0.4).then_some(Crossing { frequency: x, bounds: true });
        let [piece] = &branches(&Given { test: circle, crossing, seeds: vec![ACROSS] }, 1e-4)[..] else { panic!() };
        assert!(!piece.closed && (piece.spots[0].at[0] - 0.4).abs() < 1e-9);
        assert!((piece.spots[piece.spots.len() - 1].at[0] - 0.4).abs() < 1e-9);
        let steps = piece.spots.windows(2).map(|two| length(between(two[0].at, two[1].at)));
        assert!(steps.clone().fold(0.0, f64::max) < 0.1 && steps.fold(f64::INFINITY, f64::min) > 0.0);
    }

    #[test]
    fn branches_that_come_near_are_kept_apart_and_end_at_the_edge() {
        // Both branches of a hyperbola, 2e-3 from each other at the middle.
        let hyperbola = |[x, y]: Point| ((x - 0.5) * (y - 0.5) - 1e-6, [y - 0.5, x - 0.5]);
        let seeds = vec![[[1.0, 0.5], [1.0, 0.6]], [[0.5, 1.0], [0.6, 1.0]], [[0.0, 0.4], [0.0, 0.5]]];
        let pieces = branches(&Given { test: hyperbola, crossing: always, seeds }, 1e-5);
        assert_eq!(pieces.len(), 2);
        for piece in &pieces {
            for end in [piece.spots[0].at, piece.spots[piece.spots.len() - 1].at] {
                assert!(end.iter().any(|part| [0.0, 1.0].contains(part)), "{end:?}");
            }
            assert!(piece.spots.iter().all(|spot| (spot.at[0] > 0.5) == (piece.spots[0].at[0] > 0.5)));
        }
    }

    #[test]
    fn a_curve_that_meets_itself_is_followed_to_there() {
        // Two lines that cross in the middle: four ends at the edge.
        let lines = |[x, y]: Point| ((x - 0.5).powi(2) - (y - 0.5).powi(2), [2.0 * (x - 0.5), -2.0 * (y - 0.5)]);
        let seeds = vec![[[0.1; 2]; 2], [[0.9; 2]; 2], [[0.1, 0.9]; 2], [[0.9, 0.1]; 2]];
        let pieces = branches(&Given { test: lines, crossing: always, seeds }, 1e-4);
        assert_eq!(pieces.len(), 4);
        for piece in &pieces {
            let mut ends = [piece.spots[0].at, piece.spots[piece.spots.len() - 1].at];
            ends.sort_by(|a, b| length(between([0.5; 2], *a)).total_cmp(&length(between([0.5; 2], *b))));
            assert!(
                length(between([0.5; 2], ends[0])) < 1e-6 && ends[1].iter().all(|part| [0.0, 1.0].contains(part)),
                "{ends:?}"
            );
        }
    }
}
