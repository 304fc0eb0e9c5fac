//! Every scenario file against the cluster's logic on the host; the firmware's turn is `cargo xtask scenario`.

use bench::scenario::{HostSubject, Place, load, run};
use virtual_vehicle::Kind;

/// Runs what a vehicle's folder has for the host and lists every expectation that fails.
fn all_pass_on_the_host(kind: Kind) {
    let scenarios = load(kind).unwrap_or_else(|error| panic!("{error:#}"));
    let on_host = scenarios.iter().filter(|scenario| scenario.on.contains(&Place::Host));
    let (mut checks, mut failures) = (0, Vec::new());
    for scenario in on_host {
        let verdict = run(scenario, &mut HostSubject::new(kind, scenario.options));
        checks += verdict.checks.len();
        failures.extend(verdict.failures);
    }
    println!("{}: {checks} expectations of {} scenarios", kind.name(), scenarios.len());
    assert!(checks > 0, "{} has no scenario for the host", kind.name());
    assert!(failures.is_empty(), "{} of {checks} failed:\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn every_scenario_of_the_bus_passes_on_the_host() {
    all_pass_on_the_host(Kind::Citybus);
}

#[test]
fn every_scenario_of_jiulong_passes_on_the_host() {
    all_pass_on_the_host(Kind::Jiulong);
}

#[test]
fn every_scenario_of_c5ev_passes_on_the_host() {
    all_pass_on_the_host(Kind::C5ev);
}

#[test]
fn a_run_is_the_same_twice() {
    for kind in Kind::ALL {
        let scenarios = load(kind).unwrap_or_else(|error| panic!("{error:#}"));
        let Some(scenario) = scenarios.iter().find(|scenario| scenario.on.contains(&Place::Host)) else {
            continue;
        };
        let once = || run(scenario, &mut HostSubject::new(kind, scenario.options));
        assert_eq!(once(), once(), "{}", scenario.file);
    }
}
