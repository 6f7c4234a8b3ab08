//! A field that is written to a file and read again is bitwise identical.

use std::path::PathBuf;

use proptest::prelude::*;
use stickslip::io::pvd::PvdWriter;
use stickslip::io::vti::Array;
use stickslip::{Error, Field, Grid, History, LoadStep, NormalLoad, io};

/// Values that an inexact conversion would change.
const DELICATE: [f64; 14] = [
    0.0,
    -0.0,
    5e-324,
    -5e-324,
    2.225_073_858_507_201e-308,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::EPSILON,
    0.1,
    -1.0 / 3.0,
    1e23,
    -9007199254740993.0,
    f64::NAN,
    -7e-7,
];

fn new_field(nx: usize, ny: usize, sides: [f64; 2], values: impl Iterator<Item = f64>) -> Field {
    let grid = Grid::new(nx, ny, sides[0], sides[1]).unwrap();
    Field::from_vec(grid, values.take(nx * ny).collect()).unwrap()
}

fn delicate_fields() -> Vec<Field> {
    let sizes = [[1, 1], [1, 7], [7, 1], [2, 7], [5, 4], [14, 3]];
    let make = |[nx, ny]: [usize; 2]| new_field(nx, ny, [0.1, 0.7], DELICATE.into_iter().cycle());
    let mut fields: Vec<Field> = sizes.into_iter().map(make).collect();
    fields.push(new_field(1, 3, [1e-9, 3.0], [f64::NAN; 3].into_iter()));
    fields.push(new_field(3, 2, [1e-9, 3.0], [f64::NAN; 6].into_iter()));
    fields
}

/// Returns whether the grids are equal and the samples bitwise identical, up to the payload of NaN.
fn is_same(a: &Field, b: &Field) -> bool {
    let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
    a.grid() == b.grid() && a.as_slice().iter().zip(b.as_slice()).all(same)
}

fn sides(field: &Field) -> [f64; 2] {
    [field.grid().dx(), field.grid().dy()]
}

fn temporary_path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Returns the options for fields with huge numbers, which may otherwise mark missing points.
fn npy_options() -> io::npy::Options {
    io::npy::Options::default().missing(f64::NAN)
}

/// Returns the options for fields with huge numbers, which may otherwise mark missing points.
fn csv_options() -> io::csv::Options {
    io::csv::Options::default().missing(f64::NAN)
}

#[test]
fn delicate_fields_are_unchanged_by_files() {
    for (index, field) in delicate_fields().iter().enumerate() {
        let npy = temporary_path(&format!("round_trip_{index}.npy"));
        io::npy::write(&npy, field).unwrap();
        assert!(is_same(
            field,
            &npy_options().read(&npy, sides(field)).unwrap()
        ));

        let csv = temporary_path(&format!("round_trip_{index}.csv"));
        io::csv::write(&csv, field).unwrap();
        assert!(is_same(
            field,
            &csv_options().read(&csv, sides(field)).unwrap()
        ));

        let sdf = temporary_path(&format!("round_trip_{index}.sdf"));
        io::sdf::write(&sdf, field).unwrap();
        assert!(is_same(field, &io::sdf::read(&sdf).unwrap()));
        assert!(is_same(field, &io::read(&sdf).unwrap()));

        let vti = temporary_path(&format!("round_trip_{index}.vti"));
        io::vti::write(&vti, &[("height", field)]).unwrap();
        let text = std::fs::read_to_string(&vti).unwrap();
        assert!(is_same(field, &decode_vti(&text, "height", field.grid())));
    }
}

#[test]
fn missing_folder_is_an_error() {
    let field = Field::zeros(Grid::new(2, 2, 1.0, 1.0).unwrap());
    let nowhere = temporary_path("no_such_folder/field");
    for result in [
        io::npy::write(&nowhere, &field),
        io::csv::write(&nowhere, &field),
        io::sdf::write(&nowhere, &field),
        io::vti::write(&nowhere, &[("height", &field)]),
    ] {
        assert!(
            matches!(result, Err(Error::File { path, source, .. }) if source.code().is_some() && path.contains("no_such_folder"))
        );
    }
}

fn decode_vti(text: &str, name: &str, grid: Grid) -> Field {
    let start = format!(r#"<DataArray type="Float64" Name="{name}" format="binary">"#);
    Field::from_vec(grid, decode_vti_samples(text, &start, grid.cells())).unwrap()
}

/// Decodes the samples of an array of a VTI file, independently of the library.
fn decode_vti_samples(text: &str, start: &str, count: usize) -> Vec<f64> {
    let (_, rest) = text.split_once(start).unwrap();
    let (encoded, _) = rest.split_once("</DataArray>").unwrap();
    let mut bytes = Vec::new();
    // Padding decodes to zeros, which are dropped below because they do not complete a word.
    for four in encoded.as_bytes().chunks(4) {
        let digit = |&c: &u8| match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => 0,
        };
        let bits = four
            .iter()
            .fold(0, |bits, c| bits << 6 | u32::from(digit(c)));
        bytes.extend_from_slice(&bits.to_be_bytes()[1..]);
    }
    let words = bytes
        .chunks_exact(8)
        .map(|word| u64::from_le_bytes(word.try_into().unwrap()));
    let words: Vec<u64> = words.collect();
    assert_eq!(words[0], 8 * count as u64);
    assert_eq!(encoded.len(), (8 * words.len()).div_ceil(3) * 4);
    words[1..]
        .iter()
        .map(|&bits| f64::from_bits(bits))
        .collect()
}

#[test]
fn vtk_series_of_vectors_lists_all_files() {
    let grid = Grid::new(3, 2, 0.5, 0.25).unwrap();
    let x = Field::from_fn(grid, |x, y| x + 10.0 * y);
    let y = Field::from_fn(grid, |x, y| x * y);
    let fields = [
        ("traction", Array::from([&x, &y])),
        ("pressure", Array::from(&x)),
    ];
    let series = temporary_path("series.pvd");
    let mut written = PvdWriter::new(&series).unwrap();
    assert!(written.is_empty());
    for time in [0.0, 0.5, 1e6] {
        written.write(time, &fields).unwrap();
        let list = std::fs::read_to_string(&series).unwrap();
        assert_eq!(list.matches("<DataSet").count(), written.len());
        let number = written.len() - 1;
        let line = format!(r#"timestep="{time}" part="0" file="series.{number:04}.vti""#);
        assert!(list.contains(&line), "{list}");
    }
    kit::assert_refused! { written.write(f64::NAN, &fields) => Error::NotFinite { .. } }
    assert_eq!(written.len(), 3);
    let text = std::fs::read_to_string(temporary_path("series.0002.vti")).unwrap();
    let start =
        r#"<DataArray type="Float64" Name="traction" NumberOfComponents="3" format="binary">"#;
    let samples = decode_vti_samples(&text, start, 3 * grid.cells());
    for (cell, vector) in samples.chunks(3).enumerate() {
        assert_eq!(vector, [x.as_slice()[cell], y.as_slice()[cell], 0.0]);
    }
    assert!(is_same(&x, &decode_vti(&text, "pressure", grid)));
    // The two components must have the same grid, like all fields.
    let other = Field::zeros(Grid::new(2, 3, 0.5, 0.25).unwrap());
    kit::assert_refused! { io::vti::to_bytes(&[("traction", [&x, &other])]) => Error::Format { .. } }
}

/// Saving a history replaces the whole file. If saving fails, the old file remains.
#[test]
fn history_save_replaces_the_whole_file() {
    let grid = kit::square(16, 8.0);
    let bodies = kit::unit_bodies(grid, 0.3);
    let mut history = History::builder(&bodies, kit::sphere(grid, 10.0), kit::coulomb(0.3))
        .build()
        .unwrap();
    let file = temporary_path("history.state");
    history.save(&file).unwrap();
    history
        .step(&LoadStep::hold().normal(NormalLoad::Force(1.0)))
        .unwrap();
    history.save(&file).unwrap();
    assert_eq!(std::fs::read(&file).unwrap(), history.to_bytes());
    let restored = History::load(&bodies, &file).unwrap();
    assert_eq!(restored.to_bytes(), history.to_bytes());
    let parts = std::fs::read_dir(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let is_part = |name: String| name.starts_with("history.state.") && name.contains(".part");
    assert!(
        !parts
            .flatten()
            .any(|entry| is_part(entry.file_name().to_string_lossy().into()))
    );

    let nowhere = temporary_path("no_such_folder/history.state");
    kit::assert_refused! {
        history.save(&nowhere) => Error::File { .. },
        History::load(&bodies, &nowhere) => Error::File { .. },
    }
    std::fs::write(&file, b"cut off").unwrap();
    kit::assert_refused! {
        History::load(&bodies, &file) => Error::Format { file: Some(name), .. } if name.contains("history.state"),
    }
}

#[test]
fn sides_of_the_whole_grid_are_accepted() {
    let field = new_field(3, 4, [0.1, 0.7], DELICATE.into_iter());
    let whole = io::Sides::OfGrid([3.0 * 0.1, 4.0 * 0.7]);
    let npy = npy_options()
        .parse(&io::npy::to_bytes(&field), whole)
        .unwrap();
    let csv = csv_options()
        .parse(&io::csv::to_bytes(&field), whole)
        .unwrap();
    for read in [npy, csv] {
        assert!((read.grid().dx() - 0.1).abs() < 1e-15 && (read.grid().dy() - 0.7).abs() < 1e-15);
    }
    let flat = io::Sides::OfGrid([1.0, 0.0]);
    kit::assert_refused! { io::npy::parse(&io::npy::to_bytes(&field), flat) => Error::NotPositive { .. } }
}

#[test]
fn vti_file_with_several_fields_is_complete() {
    let grid = Grid::new(3, 2, 0.5, 0.25).unwrap();
    let pressure = Field::from_fn(grid, |x, y| x + 10.0 * y);
    let gap = Field::from_fn(grid, |x, y| x * y);
    let name = "gap <h> & \"more\"";
    let file = temporary_path("two_fields.vti");
    io::vti::write(&file, &[("pressure", &pressure), (name, &gap)]).unwrap();
    let text = std::fs::read_to_string(file).unwrap();
    assert!(
        text.contains(r#"WholeExtent="0 3 0 2 0 0" Origin="-0.75 -0.25 0" Spacing="0.5 0.25 1""#)
    );
    assert!(is_same(&pressure, &decode_vti(&text, "pressure", grid)));
    let escaped = "gap &lt;h&gt; &amp; &quot;more&quot;";
    assert!(is_same(&gap, &decode_vti(&text, escaped, grid)));

    let other = Field::zeros(Grid::new(2, 3, 0.5, 0.25).unwrap());
    for (fields, entry) in [
        (vec![], "CellData"),
        (vec![("a", &gap), ("b", &other)], "b"),
        (vec![("a", &gap), ("a", &gap)], "a"),
        (vec![("a", &gap), ("", &gap)], ""),
        (vec![("a\n", &gap)], "a\n"),
    ] {
        let error = io::vti::to_bytes(&fields).err();
        let place = io::Place::Entry(entry.into());
        assert!(matches!(error, Some(Error::Format { format: "VTI", place: p, .. }) if p == place));
    }
}

#[test]
fn sdf_side_beyond_format_limit_is_rejected() {
    let field = Field::zeros(Grid::new(1, 65536, 1.0, 1.0).unwrap());
    let error = io::sdf::to_bytes(&field).unwrap_err();
    assert_eq!(
        error.to_string(),
        "SDF, in NumProfiles: the number of points must be at most 65535, got 65536"
    );
}

/// Generates fields of arbitrary doubles, infinities included.
fn any_field() -> impl Strategy<Value = Field> {
    let value = prop_oneof![
        any::<u64>().prop_map(f64::from_bits),
        -1e3..1e3,
        proptest::sample::select(DELICATE.to_vec()),
    ];
    let side = proptest::sample::select(vec![1e-9, 0.1, 1.0, 7.3e4]);
    (1..9_usize, 1..9_usize, side.clone(), side).prop_flat_map(move |(nx, ny, dx, dy)| {
        let values = proptest::collection::vec(value.clone(), nx * ny);
        values.prop_map(move |values| new_field(nx, ny, [dx, dy], values.into_iter()))
    })
}

proptest! {
    #[test]
    fn arbitrary_fields_are_unchanged_by_formats(field in any_field()) {
        let npy = npy_options().parse(&io::npy::to_bytes(&field), sides(&field)).unwrap();
        let bits = |field: &Field| -> Vec<u64> {
            field.as_slice().iter().map(|z| z.to_bits()).collect()
        };
        prop_assert_eq!(bits(&npy), bits(&field));
        prop_assert_eq!(npy.grid(), field.grid());
        prop_assert!(is_same(&csv_options().parse(&io::csv::to_bytes(&field), sides(&field)).unwrap(), &field));

        let vti = io::vti::to_bytes(&[("height", &field)]).unwrap();
        let text = String::from_utf8(vti).unwrap();
        prop_assert!(is_same(&decode_vti(&text, "height", field.grid()), &field));

        // These two values mark a missing point in an SDF file.
        let mut measured = field;
        for z in measured.as_mut_slice() {
            if *z <= f64::MIN {
                *z = f64::NAN;
            }
        }
        prop_assert!(is_same(&io::sdf::parse(&io::sdf::to_bytes(&measured).unwrap()).unwrap(), &measured));
    }
}

/// Returns the numbers of an array that is appended to the XML as bytes.
fn decode_appended(file: &[u8], name: &str) -> Vec<f64> {
    let start = b"<AppendedData encoding=\"raw\">\n   _";
    let data = file
        .windows(start.len())
        .position(|part| part == start)
        .unwrap();
    let header = std::str::from_utf8(&file[..data]).unwrap();
    let (_, rest) = header.split_once(&format!(r#"Name="{name}""#)).unwrap();
    let (_, rest) = rest.split_once(r#"offset=""#).unwrap();
    let offset: usize = rest.split_once('"').unwrap().0.parse().unwrap();
    let words: Vec<_> = file[data + start.len() + offset..]
        .chunks_exact(8)
        .collect();
    let bytes = u64::from_le_bytes(words[0].try_into().unwrap());
    let numbers = words[1..=bytes as usize / 8].iter();
    numbers
        .map(|word| f64::from_le_bytes((*word).try_into().unwrap()))
        .collect()
}

/// All planes of a volume are written without loss of bits, in the order of increasing z, for both bodies.
#[test]
fn vti_volume_of_stress_contains_all_planes() {
    use stickslip::subsurface::{Body, Planes, Stress, Tractions};
    use stickslip::{ElasticPair, HalfSpace, Material};

    let grid = Grid::new(5, 4, 0.5, 0.25).unwrap();
    let body = |nu| Material::new(3.0, nu).unwrap();
    let bodies = HalfSpace::new(grid, ElasticPair::new(body(0.3), body(0.1)).unwrap()).unwrap();
    let pressure = Field::from_fn(grid, |x, y| 1.0 + x * y);
    let shear = [&pressure.scaled(0.3), &pressure.scaled(-0.1)];
    let bulk = Stress {
        xx: 8.0,
        yy: 2.0,
        ..Stress::default()
    };
    let alone = Tractions::new(&pressure).with_traction(shear);
    let tractions = alone.with_uniform_stress(bulk);
    let depths = [0.1, 0.3, 0.5];
    let mut planes = Planes::new(&bodies, &depths).unwrap().with_displacements();
    let path = temporary_path("slab.vti");
    for (body, order, lowest) in [(Body::One, [0, 1, 2], 0.1), (Body::Two, [2, 1, 0], -0.5)] {
        planes.write_vti(&path, body, tractions).unwrap();
        let file = std::fs::read(&path).unwrap();
        let text = String::from_utf8_lossy(&file);
        let image = format!(
            r#"<ImageData WholeExtent="0 4 0 3 0 2" Origin="-1 -0.375 {lowest}" Spacing="0.5 0.25 0.2""#
        );
        assert!(text.contains(&image), "{text}");
        assert!(text.ends_with("</AppendedData>\n</VTKFile>\n"));
        let [tensors, equivalent, vectors] =
            ["stress", "von_mises", "displacement"].map(|name| decode_appended(&file, name));
        assert_eq!(equivalent.len(), 60);
        for (level, index) in order.into_iter().enumerate() {
            let plane = planes.solve(index, body, tractions).unwrap();
            let [ux, uy, uz] = plane.displacement().unwrap();
            let without = planes.solve(index, body, alone).unwrap();
            let without: Vec<Stress> = without.stresses().collect();
            for (cell, stress) in plane.stresses().enumerate() {
                let point = 20 * level + cell;
                let s = without[cell] + bulk;
                assert_eq!(s, stress);
                assert_eq!(
                    tensors[6 * point..][..6],
                    [s.xx, s.yy, s.zz, s.xy, s.yz, s.xz]
                );
                assert_eq!(equivalent[point], s.von_mises());
                let u = [ux, uy, uz].map(|u| u.as_slice()[cell]);
                assert_eq!(vectors[3 * point..][..3], u);
            }
        }
    }
    // Planes that cannot be written leave the file unchanged.
    let before = std::fs::read(&path).unwrap();
    for bad in [&[0.1, 0.2, 0.4][..], &[0.2, 0.1], &[0.1, 0.1]] {
        let mut planes = Planes::new(&bodies, bad).unwrap();
        kit::assert_refused! { planes.write_vti(&path, Body::One, tractions) => Error::Sample { .. } }
    }
    kit::assert_refused! {
        Planes::new(&bodies, &[]).unwrap().write_vti(&path, Body::One, tractions) => Error::Length { .. },
    }
    let broken = Field::constant(grid, f64::NAN);
    kit::assert_refused! { planes.write_vti(&path, Body::One, Tractions::new(&broken)) => Error::Sample { .. } }
    assert_eq!(std::fs::read(&path).unwrap(), before);
    let nowhere = temporary_path("no_such_folder").join("slab.vti");
    kit::assert_refused! { planes.write_vti(&nowhere, Body::One, tractions) => Error::File { .. } }
}
