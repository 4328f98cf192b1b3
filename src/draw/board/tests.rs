use super::*;
use crate::draw::shapes::round;
use crate::draw::{DrawnPath, Paper};

const PAPER: Paper = Paper {
    surround: [0.2, 0.4, 0.6, 1.0],
    bed: [0.6, 0.4, 0.2, 1.0],
    line: [1.0, 1.0, 1.0, 1.0],
};
const WHITE: Colour = [1.0; 4];

fn square(lo: f64, hi: f64) -> Vec<DVec2> {
    [(lo, lo), (hi, lo), (hi, hi), (lo, hi)]
        .map(DVec2::from)
        .to_vec()
}

fn edges(rings: Vec<Vec<DVec2>>, colour: Colour, width: f64, round: f64) -> Layer {
    Layer::shapes(vec![DrawnPath::bare(rings)]).edged(colour, width, round)
}

fn line(points: [(f64, f64); 2], colour: Colour, width: f64) -> Layer {
    Layer::lines(vec![points.map(DVec2::from).to_vec()], colour, width)
}

fn pixel(board: &Board, x: usize, y: usize) -> [u8; 4] {
    std::array::from_fn(|k| board.rgba()[4 * (y * 64 + x) + k])
}

fn bytes(colour: Colour) -> [u8; 4] {
    colour.map(|c| (255.0 * c + 0.5) as u8)
}

#[test]
fn the_bed_has_its_hole() {
    let mut hole = square(24.0, 40.0);
    hole.reverse();
    let mut board = Board::new(64, PAPER.surround);
    let rings = [&square(8.0, 56.0)[..], &hole];
    board.fill(&rings, PAPER.bed, 0.0);
    assert_eq!(pixel(&board, 2, 2), bytes(PAPER.surround));
    assert_eq!(pixel(&board, 32, 32), bytes(PAPER.surround));
    assert_eq!(pixel(&board, 16, 32), bytes(PAPER.bed));
    assert!(board.rgba().chunks(4).all(|p| p[3] == 255));
}

#[test]
fn what_leaves_a_tile_comes_in_again() {
    let mut board = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
    board.fill(&[&square(-6.0, 6.0)], WHITE, 0.0);
    assert_eq!(pixel(&board, 61, 61)[0], 0);
    board.repeat();
    board.fill(&[&square(-6.0, 6.0)], WHITE, 0.0);
    for (x, y) in [(2, 2), (61, 2), (2, 61), (61, 61)] {
        assert_eq!(pixel(&board, x, y)[0], 255, "{x} {y}");
    }
    assert_eq!(pixel(&board, 32, 32)[0], 0);
}

#[test]
fn lines_that_leave_a_tile_come_in_again_and_fill_nothing() {
    let mut board = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
    board.repeat();
    let rings = vec![square(-10.0, 10.0), square(20.0, 40.0)];
    board.draw(&[edges(rings, WHITE, 2.0, 0.0)]);
    for (x, y) in [(10, 3), (54, 3), (54, 60), (3, 54), (20, 30)] {
        assert!(pixel(&board, x, y)[0] > 100, "{x} {y}");
    }
    for (x, y) in [(3, 3), (60, 60), (60, 3), (30, 30), (50, 50)] {
        assert_eq!(pixel(&board, x, y)[0], 0, "{x} {y}");
    }
    let mut bars = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
    bars.repeat();
    bars.draw(&[line([(60.0, 30.0), (70.0, 30.0)], WHITE, 4.0)]);
    assert_eq!([pixel(&bars, 62, 30)[0], pixel(&bars, 3, 30)[0]], [255; 2]);
    assert_eq!(pixel(&bars, 30, 30)[0], 0);
}

#[test]
fn rows_are_drawn_as_they_are_with_all_others() {
    let draw = |board: &mut Board| {
        board.fill(&[&round(DVec2::new(60.0, 55.0), 23.7)], WHITE, 0.0);
        let rings = vec![square(-10.2, 33.3)];
        board.draw(&[
            edges(rings, PAPER.surround, 2.3, 4.0),
            line([(3.0, 61.7), (50.0, 9.1)], PAPER.line, 1.6),
        ]);
    };
    for tile in [false, true] {
        let [mut whole, mut pieces] = [(); 2].map(|()| Board::new(64, PAPER.bed));
        (whole.tile, pieces.tile) = (tile, tile);
        draw(&mut whole);
        for from in (0..64).step_by(16) {
            let before = pieces.rgba().to_vec();
            pieces.within(from..from + 16, draw);
            let (start, end) = (256 * from, 256 * (from + 16));
            assert_eq!(before[..start], pieces.rgba()[..start]);
            assert_eq!(before[end..], pieces.rgba()[end..]);
        }
        // Lines cut at another row may cover another of a pixel's 16 samples.
        let pairs = whole.rgba().iter().zip(pieces.rgba());
        let others: Vec<u8> = pairs
            .map(|(a, b)| a.abs_diff(*b))
            .filter(|&d| d > 0)
            .collect();
        assert!(others.len() < 400, "{} bytes", others.len());
        assert!(others.iter().all(|&d| d <= 17), "{others:?}");
    }
}

/// The mean of `by` x `by` pixels for each pixel of a picture.
fn averaged(board: &Board, by: usize) -> Vec<u8> {
    let fine = board.side();
    let side = fine / by;
    let value = |k: usize| {
        let (x, y) = (k / 4 % side, k / 4 / side);
        let at = |n: usize| 4 * ((by * y + n / by) * fine + by * x + n % by) + k % 4;
        let sum: usize = (0..by * by).map(|n| usize::from(board.rgba()[at(n)])).sum();
        (sum / (by * by)) as u8
    };
    (0..4 * side * side).map(value).collect()
}

#[test]
fn more_pixels_show_the_same_drawing() {
    let layers = [
        Layer::fill(vec![round(DVec2::new(60.0, 55.0), 23.7)], WHITE, 0.0),
        Layer::fill(vec![square(5.3, 20.6)], PAPER.line, 4.0),
        edges(vec![square(-10.2, 33.3)], PAPER.surround, 2.3, 4.0),
        line([(3.0, 61.7), (50.0, 9.1)], PAPER.line, 0.7),
    ];
    for tile in [false, true] {
        let [plain, two, three] = [1, 2, 3].map(|scale| {
            let mut board = Board::scaled(64, scale, PAPER.bed);
            board.tile = tile;
            board.draw(&layers);
            assert!(board.fits(64) && !board.fits(64 * scale + 1));
            board
        });
        for (fine, by) in [(&two, 2), (&three, 3)] {
            assert_eq!(fine.side(), 64 * by);
            let pairs = averaged(fine, by)
                .into_iter()
                .zip(plain.rgba().iter().copied());
            let off: Vec<u8> = pairs.map(|(a, b)| a.abs_diff(b)).collect();
            let sum: usize = off.iter().map(|&d| usize::from(d)).sum();
            assert!(off.iter().all(|&d| d < 40), "{by}: {:?}", off.iter().max());
            assert!(sum < off.len(), "{by}: {sum} of {}", off.len());
        }
    }
}

#[test]
fn rows_of_a_finer_drawing_are_those_of_the_whole() {
    let draw = |board: &mut Board| {
        board.fill(&[&square(10.0, 50.0)], WHITE, 0.0);
        board.draw(&[line([(10.0, 60.0), (50.0, 60.0)], PAPER.line, 2.0)]);
    };
    for scale in [2, 3] {
        let [mut whole, mut pieces] = [(); 2].map(|()| Board::scaled(64, scale, PAPER.bed));
        draw(&mut whole);
        for from in (0..64 * scale).step_by(16) {
            pieces.within(from..from + 16, draw);
        }
        assert_eq!(whole.rgba(), pieces.rgba());
    }
}

#[test]
fn an_enlarged_picture_is_the_same_with_colours_between() {
    let mut board = Board::new(64, PAPER.surround);
    for (k, pixel) in board.rgba_mut().chunks_exact_mut(4).enumerate() {
        pixel[0] = 3 * (k % 64) as u8;
        pixel[1] = 2 * (k / 64) as u8;
    }
    for by in [2, 3] {
        let large = board.enlarged(by);
        assert_eq!((large.side(), large.scale()), (64 * by, by));
        let pairs = averaged(&large, by)
            .into_iter()
            .zip(board.rgba().iter().copied());
        assert!(pairs.clone().all(|(a, b)| a.abs_diff(b) < 2));
        let row: Vec<u8> = large.rgba().chunks(4).take(64 * by).map(|p| p[0]).collect();
        assert!(row.is_sorted() && row.iter().zip(&row[1..]).all(|(a, b)| b - a < 3));
        assert_eq!([row[0], row[64 * by - 1]], [0, 189]);
        assert_eq!(large.enlarged(by).rgba(), large.rgba());
    }
    assert_eq!(board.enlarged(1).rgba(), board.rgba());
}

#[test]
fn half_covered_pixels_are_half_filled() {
    let mut board = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
    board.fill(&[&square(10.5, 20.0)], WHITE, 0.0);
    assert_eq!(pixel(&board, 15, 15)[0], 255);
    let half = pixel(&board, 10, 15)[0];
    assert!((120..=136).contains(&half), "{half}");
    assert_eq!(pixel(&board, 9, 15)[0], 0);
}

#[test]
fn rounded_corners_are_cut_and_sides_are_not() {
    let mut board = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
    board.fill(&[&square(10.0, 50.0)], WHITE, 8.0);
    assert_eq!(pixel(&board, 10, 10)[0], 0);
    assert_eq!(pixel(&board, 10, 30)[0], 255);
    assert_eq!(pixel(&board, 30, 49)[0], 255);
}

#[test]
fn what_reaches_beyond_the_board_is_cut() {
    let mut board = Board::new(64, PAPER.surround);
    board.fill(&[&square(-30.0, 10.0)], WHITE, 0.0);
    board.fill(&[&square(50.0, 1e7)], WHITE, 0.0);
    assert_eq!(pixel(&board, 3, 9)[0], 255);
    assert_eq!(pixel(&board, 63, 63)[0], 255);
    assert_eq!(pixel(&board, 12, 3), bytes(PAPER.surround));
    assert_eq!(pixel(&board, 48, 63), bytes(PAPER.surround));
}

#[test]
fn empty_and_far_away_rings_draw_nothing() {
    let mut board = Board::new(64, PAPER.surround);
    let before = board.rgba().to_vec();
    let far = square(1e7, 2e7);
    for ring in [&[][..], &[DVec2::ZERO], &far, &[DVec2::NAN; 3]] {
        board.fill(&[ring], WHITE, 1.0);
        board.draw(&[edges(vec![ring.to_vec()], WHITE, 1.0, 1.0)]);
    }
    board.draw(&[Layer::lines(Vec::new(), WHITE, 1.0)]);
    board.draw(&[line([(f64::NAN, f64::NAN); 2], WHITE, 1.0)]);
    assert_eq!(before, board.rgba());
}

#[test]
fn a_picture_is_shown_as_it_is() {
    let mut board = Board::new(64, PAPER.surround);
    let picture: Vec<u8> = (0..64 * 64 * 4).map(|k| (k % 251) as u8).collect();
    board.show(&picture);
    assert_eq!(board.rgba(), picture);
    board.show(&[]);
    assert_eq!(board.rgba(), picture);
    assert!(board.fits(64) && !board.fits(65));
}
