//! Frames and messages: what is written is read back, types have their names in ROS 1 and 2, and what is no number is told
//! apart by how it was written.

use groundling::robot::frame::{Frame, MOST_BYTES, Misread};
use groundling::robot::geometry::{Pose, Twist, quaternion, wrap, yaw};
use groundling::robot::message::{Command, Flaw, Generation, Sighting};
use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};
use serde_json::{Value, json};

#[test]
fn a_frame_that_is_written_reads_back() {
    for (text, op) in [
        (
            r#"{"op":"advertise","id":"advertise:/cmd_vel:1","type":"geometry_msgs/Twist","topic":"/cmd_vel","latch":false,"queue_size":100}"#,
            "advertise",
        ),
        (r#"{"op":"unadvertise","id":"a","topic":"/cmd_vel"}"#, "unadvertise"),
        (r#"{"op":"publish","topic":"/odom","msg":{"x":[1,null,"é"]}}"#, "publish"),
        (r#"{"op":"subscribe","topic":"/odom"}"#, "subscribe"),
        (r#"{"op":"unsubscribe","topic":"/odom"}"#, "unsubscribe"),
        (r#"{"op":"call_service","id":"x","service":"/rosapi/topics"}"#, "call_service"),
        (
            r#"{"op":"service_response","id":"x","values":{"type":""},"result":true}"#,
            "service_response",
        ),
        (r#"{"op":"status","level":"error","msg":"no"}"#, "status"),
    ] {
        let frame = Frame::read(text).unwrap();
        let written = frame.write();
        assert_eq!(Frame::read(&written).unwrap(), frame, "{written}");
        let value: Value = serde_json::from_str(&written).unwrap();
        assert_eq!(value["op"], op);
        let given: Value = serde_json::from_str(text).unwrap();
        for (name, field) in given.as_object().unwrap() {
            assert_eq!(&value[name], field, "{name} of {written}");
        }
    }
    assert_eq!(
        Frame::read(r#"{"op":"fragment","id":"x","data":"{","num":0,"total":2}"#),
        Ok(Frame::Other)
    );
}

#[test]
fn what_is_no_frame_is_told_apart() {
    let read = |text: &str| Frame::read(text).unwrap_err();
    for (text, word) in [
        (r#"{"op":"publish","topic":"/odom","msg":{"x":NaN}}"#, "NaN"),
        (r#"{"op":"publish","topic":"NaN","msg":{"x":Infinity}}"#, "Infinity"),
        (r#"{"op":"publish","topic":"\"NaN","msg":{"x":-Infinity}}"#, "-Infinity"),
    ] {
        assert_eq!(read(text), Misread::Bare(word));
    }
    // A name may be NaN.
    assert!(matches!(read(r#"{"op":"publish","topic":"NaN","msg":}"#), Misread::NotJson(_)));
    assert!(matches!(read(""), Misread::NotJson(_)));
    assert!(matches!(read("[]"), Misread::NoFrame(_)));
    assert!(matches!(read("{}"), Misread::NoFrame(_)));
    assert!(matches!(read(r#"{"op":3}"#), Misread::NoFrame(_)));
    assert!(matches!(read(r#"{"op":"publish"}"#), Misread::NoFrame(_)));
    assert!(matches!(read(&"[".repeat(10_000)), Misread::NotJson(_)));
    assert_eq!(read(&" ".repeat(MOST_BYTES + 1)), Misread::TooLong(MOST_BYTES + 1));
}

#[test]
fn types_have_their_names_in_ros_1_and_2() {
    for generation in [Generation::One, Generation::Two] {
        for command in [Command::Twist, Command::TwistStamped] {
            assert_eq!(Command::of(&command.name(generation)), Some((command, generation)));
        }
        let all = [Sighting::Odometry, Sighting::PoseStamped, Sighting::PoseWithCovariance];
        for sighting in all {
            assert_eq!(Sighting::of(&sighting.name(generation)), Some((sighting, generation)));
        }
    }
    assert_eq!(Command::Twist.name(Generation::One), "geometry_msgs/Twist");
    assert_eq!(Command::TwistStamped.name(Generation::Two), "geometry_msgs/msg/TwistStamped");
    assert_eq!(Sighting::Odometry.name(Generation::Two), "nav_msgs/msg/Odometry");
    for name in
        ["", "Twist", "other/Twist", "geometry_msgs/srv/Twist", "geometry_msgs/msg/msg/Twist"]
    {
        assert_eq!((Command::of(name), Sighting::of(name)), (None, None), "{name}");
    }
}

#[test]
fn a_pose_is_read_and_its_flaws_are_said() {
    let message = |x: Value, w: Value| {
        json!({ "pose": { "pose": { "position": { "x": x, "y": 2, "z": 0.0 },
            "orientation": { "x": 0.0, "y": 0.0, "z": 0.0, "w": w } }, "covariance": [] } })
    };
    let read = |x, w| Sighting::Odometry.pose(&message(x, w));
    assert_eq!(read(json!(1.5), json!(1)), Ok(Pose { x: 1.5, y: 2.0, heading: 0.0 }));
    assert_eq!(read(json!(null), json!(1)), Err(Flaw::Null("pose.pose.position.x".into())));
    assert_eq!(read(json!("1"), json!(1)), Err(Flaw::Missing("pose.pose.position.x".into())));
    assert_eq!(read(json!(1), json!(0)), Err(Flaw::NoTurn));
    let stamped = Sighting::PoseStamped.pose(&message(json!(1), json!(1)));
    assert_eq!(stamped, Err(Flaw::Missing("pose.orientation.x".into())));
}

#[test]
fn a_velocity_that_is_no_number_is_no_message() {
    for generation in [Generation::One, Generation::Two] {
        for command in [Command::Twist, Command::TwistStamped] {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let both =
                    [Twist { linear: bad, angular: 0.0 }, Twist { linear: 0.0, angular: bad }];
                assert!(both.iter().all(|&twist| command.message(generation, twist).is_none()));
            }
            let twist = Twist { linear: 0.1, angular: -0.2 };
            let message = command.message(generation, twist).unwrap();
            assert_eq!(command.velocity(&message), Ok(twist), "{message}");
        }
    }
    let stamped = Command::TwistStamped.message(Generation::One, Twist::STOP).unwrap();
    assert_eq!(stamped["header"]["stamp"], json!({ "secs": 0, "nsecs": 0 }));
    let stamped = Command::TwistStamped.message(Generation::Two, Twist::STOP).unwrap();
    assert_eq!(stamped["header"], json!({ "stamp": { "sec": 0, "nanosec": 0 }, "frame_id": "" }));
    assert_eq!(
        Twist { linear: f64::NAN, angular: 9.0 }.capped(0.2, 1.0),
        Twist { linear: 0.0, angular: 1.0 }
    );
}

proptest! {
    #[test]
    fn no_text_makes_the_reader_panic(text in "\\PC{0,200}") {
        let _ = Frame::read(&text);
        let _ = Frame::read(&format!(r#"{{"op":"publish","topic":"/odom","msg":{text}}}"#));
    }

    #[test]
    fn a_frame_of_any_words_reads_back(topic in any::<String>(), x in any::<i32>()) {
        let frame = Frame::Publish { id: Some(topic.clone()), topic, msg: json!({ "x": f64::from(x) / 8.0 }) };
        prop_assert_eq!(Frame::read(&frame.write()), Ok(frame));
    }

    #[test]
    fn a_heading_goes_through_a_quaternion(heading in -20.0..20.0_f64) {
        let wrapped = wrap(heading);
        prop_assert!(wrapped > -std::f64::consts::PI - 1e-12 && wrapped <= std::f64::consts::PI);
        prop_assert!(wrap(yaw(quaternion(wrapped)).unwrap() - heading).abs() < 1e-9);
    }
}
