//! A conversation with a rosbridge: what is asked in which order, what is asked anew after an outage and what is not, and
//! that nothing is kept to be sent.

use groundling::robot::frame::Frame;
use groundling::robot::geometry::Twist;
use groundling::robot::message::{Command, Generation, Sighting};
use groundling::robot::session::{Bad, Kind, News, Session};
use groundling::robot::wiring::{Types, Wiring};
use serde_json::{Value, json};

const SLOW: Twist = Twist { linear: 0.1, angular: 0.0 };

fn values(frames: &[String]) -> Vec<Value> {
    frames.iter().map(|frame| serde_json::from_str(frame).unwrap()).collect()
}

fn answer(id: &Value, kind: &str) -> String {
    json!({ "op": "service_response", "id": id, "service": "/rosapi/topic_type",
        "values": { "type": kind }, "result": true })
    .to_string()
}

/// A session whose questions are answered so; the frames that came of it.
fn answered(session: &mut Session, velocity: &str, pose: &str) -> Vec<Value> {
    let asked = values(&session.opened());
    assert_eq!(asked.len(), 2);
    let mut frames = Vec::new();
    for (question, kind) in asked.iter().zip([velocity, pose]) {
        assert_eq!(
            (&question["op"], &question["service"]),
            (&json!("call_service"), &json!("/rosapi/topic_type"))
        );
        let (news, more) = session.heard(&answer(&question["id"], kind));
        assert_eq!(news, vec![News::Known]);
        frames.extend(values(&more));
    }
    frames
}

#[test]
fn types_are_asked_and_used() {
    for (kind, command, generation) in [
        ("geometry_msgs/Twist", Command::Twist, Generation::One),
        ("geometry_msgs/msg/Twist", Command::Twist, Generation::Two),
        ("geometry_msgs/msg/TwistStamped", Command::TwistStamped, Generation::Two),
    ] {
        let mut session = Session::new(Wiring::default());
        let odometry = Sighting::Odometry.name(generation);
        let frames = answered(&mut session, kind, &odometry);
        assert_eq!(session.command(), Some((command, generation)));
        assert_eq!(frames.len(), 1, "nothing is advertised before it may be");
        assert_eq!((&frames[0]["op"], &frames[0]["type"]), (&json!("subscribe"), &json!(odometry)));
        assert_eq!(session.publish(SLOW), None, "nor published");
        let frames = values(&session.arm(true));
        assert_eq!((&frames[0]["op"], &frames[0]["type"]), (&json!("advertise"), &json!(kind)));
        let Some(text) = session.publish(SLOW) else { panic!("nothing is published") };
        let Ok(Frame::Publish { topic, msg, id: Some(id) }) = Frame::read(&text) else {
            panic!("{text}")
        };
        assert_eq!((topic.as_str(), command.velocity(&msg)), ("/cmd_vel", Ok(SLOW)));
        assert!(id.starts_with("publish:/cmd_vel:"));
        assert_eq!(session.publish(Twist { linear: f64::NAN, angular: 0.0 }), None);
        assert_eq!(values(&session.arm(false))[0]["op"], "unadvertise");
        assert_eq!(session.publish(SLOW), None);
    }
}

#[test]
fn after_an_outage_what_is_open_is_asked_anew_and_nothing_was_kept() {
    let mut session = Session::new(Wiring::default());
    answered(&mut session, "geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry");
    session.arm(true);
    session.closed();
    assert!((0..50).all(|_| session.publish(SLOW).is_none()), "nothing while it is closed");
    let frames = answered(&mut session, "geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry");
    let ops: Vec<&str> = frames.iter().filter_map(|frame| frame["op"].as_str()).collect();
    assert_eq!(ops, ["advertise", "subscribe"], "both, and no velocity of before");
    assert!(session.publish(SLOW).is_some());
    // What was given up is not asked for.
    session.arm(false);
    session.closed();
    let frames = answered(&mut session, "geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry");
    assert_eq!(frames.iter().map(|frame| &frame["op"]).collect::<Vec<_>>(), ["subscribe"]);
    // What is given up while there is no link is not, either.
    session.arm(true);
    session.closed();
    assert!(session.arm(false).is_empty());
    let frames = answered(&mut session, "geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry");
    assert_eq!(frames.iter().map(|frame| &frame["op"]).collect::<Vec<_>>(), ["subscribe"]);
}

#[test]
fn a_topic_used_both_ways_gets_both_back() {
    // A base that says where it is on the topic that it is driven by is none; the names may still be alike.
    let wiring = Wiring { pose: "/cmd_vel".to_owned(), ..Wiring::default() };
    let types = Types {
        generation: Generation::One,
        command: Command::Twist,
        sighting: Sighting::Odometry,
    };
    let mut session = Session::new(Wiring { types: Some(types), ..wiring });
    session.arm(true);
    for _ in 0..3 {
        let ops: Vec<Value> =
            values(&session.opened()).iter().map(|frame| frame["op"].clone()).collect();
        assert_eq!(ops, ["advertise", "subscribe"]);
        session.closed();
    }
}

#[test]
fn answers_that_do_not_serve_are_told_apart() {
    let mut session = Session::new(Wiring::default());
    let asked = values(&session.opened());
    let id = &asked[0]["id"];
    session.heard(&answer(id, ""));
    assert_eq!(session.topics()[0].kind, Kind::Absent);
    let asked = values(&session.opened());
    session.heard(&answer(&asked[0]["id"], "std_msgs/String"));
    assert_eq!(session.topics()[0].kind, Kind::Other("std_msgs/String".into()));
    let failed = json!({ "op": "service_response", "id": asked[1]["id"], "service": "/rosapi/topic_type",
        "values": "Service /rosapi/topic_type does not exist", "result": false });
    let (news, _) = session.heard(&failed.to_string());
    let why = "Service /rosapi/topic_type does not exist".to_owned();
    assert_eq!(news, vec![News::Bad(Bad::Service("/rosapi/topic_type".into(), why.clone()))]);
    assert_eq!(session.topics()[1].kind, Kind::Failed(why));
    // An answer to nobody, and a second one.
    assert_eq!(session.heard(&answer(&json!("other"), "nav_msgs/Odometry")), (vec![], vec![]));
    assert_eq!(session.heard(&answer(id, "nav_msgs/Odometry")), (vec![], vec![]));
}

#[test]
fn nan_null_and_complaints_are_told_apart() {
    let mut session = Session::new(Wiring::default());
    answered(&mut session, "geometry_msgs/Twist", "nav_msgs/Odometry");
    let said = |session: &mut Session, text: &str| match &session.heard(text).0[..] {
        [News::Bad(bad)] => bad.to_string(),
        other => panic!("{text}: {other:?}"),
    };
    let pose = |x: &str| {
        format!(
            r#"{{"op":"publish","topic":"/odom","msg":{{"pose":{{"pose":{{"position":{{"x":{x},"y":0,"z":0}},"orientation":{{"x":0,"y":0,"z":0,"w":1}}}}}}}}}}"#
        )
    };
    assert_eq!(said(&mut session, &pose("NaN")), "a bare NaN, which is no JSON");
    assert_eq!(
        said(&mut session, &pose("null")),
        "/odom: null where a number belongs, in pose.pose.position.x"
    );
    assert_eq!(said(&mut session, &pose("\"one\"")), "/odom: no number in pose.pose.position.x");
    let complaint =
        r#"{"op":"status","level":"error","msg":"no such type","id":"advertise:/cmd_vel:3"}"#;
    assert_eq!(said(&mut session, complaint), "the bridge says: no such type");
    assert!(matches!(&session.heard(&pose("1.0")).0[..], [News::Robot(_)]));
    assert_eq!(session.heard(r#"{"op":"status","level":"info","msg":"hello"}"#).0, vec![]);
    assert_eq!(session.heard(r#"{"op":"publish","topic":"/scan","msg":{}}"#).0, vec![]);
}

/// The frames of a whole conversation, which other clients' are held against: `tests/e2e/flows/28-robot-clients.mjs`,
/// `tests/peers/roslibpy_client.py`.
const FRAMES: &str = include_str!("../../data/robot/frames.jsonl");

#[test]
fn the_frames_of_a_conversation_are_those_of_the_file() {
    let mut session = Session::new(Wiring::default());
    let mut frames = session.opened();
    for (kind, id) in
        ["geometry_msgs/msg/TwistStamped", "nav_msgs/msg/Odometry"].iter().zip(["1", "2"])
    {
        let id = json!(format!("call_service:/rosapi/topic_type:{id}"));
        frames.extend(session.heard(&answer(&id, kind)).1);
    }
    frames.extend(session.arm(true));
    frames.extend(session.publish(SLOW));
    frames.extend(session.arm(false));
    assert_eq!(frames.join("\n") + "\n", FRAMES);
}
