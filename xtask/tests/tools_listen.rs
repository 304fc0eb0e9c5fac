//! `cargo xtask listen`: a port that it sets up by itself, files, and sources that hold nothing of a cluster.

mod program;

use program::xtask;
use protocol_core::link::{MAX_FRAME, Record, encode};
use std::process::{Output, Stdio};

fn listen(source: &str) -> Output {
    xtask().args(["listen", source]).stdin(Stdio::null()).output().unwrap()
}

fn hello() -> Vec<u8> {
    let record = Record::Hello { version: "0.1.0".into(), vehicle: "citybus".into(), build: 7 };
    let mut frame = [0; MAX_FRAME];
    let length = encode(&record, &mut frame).unwrap();
    frame[..length].to_vec()
}

#[test]
fn a_file_without_a_record_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in [("hostname", &b"vehicle\n"[..]), ("empty", b"")] {
        let path = folder.path().join(name);
        std::fs::write(&path, content).unwrap();
        let output = listen(path.to_str().unwrap());
        assert_eq!(output.status.code(), Some(1), "{output:?}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains(&format!("{name}: {} bytes and no record", content.len())), "{said}");
    }
    let output = listen("-");
    assert_eq!(output.status.code(), Some(1), "{output:?}");
}

#[test]
fn a_file_with_what_came_from_a_cluster_is_printed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("uart.bin");
    std::fs::write(&path, hello()).unwrap();
    let output = listen(path.to_str().unwrap());
    assert!(output.status.success(), "{output:?}");
    assert_eq!(
        String::from_utf8(output.stdout).unwrap(),
        "hello   firmware 0.1.0 for citybus, build 00000007\n"
    );
}

#[test]
fn what_a_cluster_says_cannot_steer_the_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("uart.bin");
    let records = [
        Record::Hello { version: "\u{1b}[2J".into(), vehicle: "\u{9b}2J\n".into(), build: 7 },
        Record::Panic { line: 3, text: "\u{1b}]0;x\u{7}\u{202e}\nhello".into() },
    ];
    let mut bytes = Vec::new();
    for record in &records {
        let mut frame = [0; MAX_FRAME];
        let length = encode(record, &mut frame).unwrap();
        bytes.extend_from_slice(&frame[..length]);
    }
    std::fs::write(&path, bytes).unwrap();
    let printed = String::from_utf8(listen(path.to_str().unwrap()).stdout).unwrap();
    let expected = "hello   firmware \\u{1b}[2J for \\u{9b}2J\\n, build 00000007\n\
                    panic   line 3: \\u{1b}]0;x\\u{7}\\u{202e}\\nhello\n";
    assert_eq!(printed, expected);
}

#[cfg(unix)]
#[test]
fn a_device_that_is_no_serial_port_is_named() {
    let output = listen("/dev/null");
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("cannot open /dev/null") && said.contains("it is not a serial port"), "{said}");
}

#[cfg(unix)]
#[test]
fn a_serial_port_is_set_up_and_heard() {
    use bench::join::pty::Pty;
    use bench::join::wire::Wire;
    use std::io::{BufRead, BufReader};
    use std::time::Duration;

    let mut pty = Pty::open().unwrap();
    let mut child =
        xtask().arg("listen").arg(pty.path()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let stdout = BufReader::new(child.stdout.take().unwrap());
    let (sender, lines) = std::sync::mpsc::channel();
    let reader = std::thread::spawn(move || {
        stdout.lines().map(Result::unwrap).try_for_each(|line| sender.send(line)).is_ok()
    });
    // What is sent before the port is set up is thrown away by that; a cluster says it again, too. A minute is for ever.
    let heard = (0..1_200).find_map(|_| {
        if pty.is_connected().unwrap() {
            pty.write(&hello()).unwrap();
        }
        lines.recv_timeout(Duration::from_millis(50)).ok()
    });
    // Ends the program, heard or not.
    drop(pty);
    let output = child.wait_with_output().unwrap();
    assert_eq!(heard.as_deref(), Some("hello   firmware 0.1.0 for citybus, build 00000007"));
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("is gone"), "{said}");
    drop(lines);
    reader.join().unwrap();
}
