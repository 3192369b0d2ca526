//! Normals and rotations through the types of `mint`.
#![cfg(feature = "mint")]

use eigenshade::object::MapPoint;
use eigenshade::{Error, Normal, Rotation};

#[test]
fn normals_come_and_go() {
    let normal = Normal::try_from(mint::Vector3 { x: 0.0f32, y: 3.0, z: 4.0 }).expect("visible");
    assert_eq!(normal, Normal::new(0.0, 3.0, 4.0).expect("visible"));
    let back = mint::Vector3::from(normal);
    assert_eq!([back.x, back.y, back.z], normal.components());
    let hidden = mint::Vector3 { x: 0.0f32, y: 0.0, z: -1.0 };
    assert_eq!(Normal::try_from(hidden), Err(Error::Hidden));
    let point = MapPoint::from(mint::Vector2 { x: 0.25f32, y: -0.5 });
    assert_eq!(point.coordinates(), [0.25, -0.5]);
    assert_eq!(mint::Vector2::from(point), mint::Vector2 { x: 0.25, y: -0.5 });
}

#[test]
fn rotations_come_and_go() {
    // A quarter turn about z brings x to y.
    let half = 0.5f32.sqrt();
    let quaternion = mint::Quaternion { v: mint::Vector3 { x: 0.0, y: 0.0, z: half }, s: half };
    let rotation = Rotation::try_from(quaternion).expect("a rotation");
    let [x, y, z] = rotation.turn_direction([1.0, 0.0, 0.0]);
    assert!(x.abs() < 2e-7 && (y - 1.0).abs() < 2e-7 && z == 0.0);
    let rows = mint::RowMatrix3::from(rotation);
    assert_eq!(Rotation::try_from(rows), Ok(rotation));
    assert_eq!([rows.x.y, rows.y.x], [rotation.matrix()[0][1], rotation.matrix()[1][0]]);
    let columns = mint::ColumnMatrix3::from(rows);
    assert_eq!(Rotation::try_from(columns), Ok(rotation));
    let nothing = mint::Quaternion { v: mint::Vector3 { x: 0.0, y: 0.0, z: 0.0 }, s: 0.0f32 };
    assert_eq!(Rotation::try_from(nothing), Err(Error::Rotation));
}
