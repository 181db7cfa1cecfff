//! The dampers' tables hold together, and what is not passive is refused.
#![cfg(not(target_arch = "wasm32"))]

use shimmy::element::damper::{self, Description};

fn refused(damper: &Description, changes: &[(&str, f64)]) -> Option<String> {
    let mut values = damper.defaults();
    for (name, value) in changes {
        let place = damper.parameters.iter().position(|parameter| parameter.name == *name).unwrap();
        values[place] = *value;
    }
    damper.damper(&values).err().map(|error| error.field.clone())
}

#[test]
fn defaults_lie_within_their_sliders_and_make_a_damper() {
    for damper in damper::list() {
        for parameter in damper.parameters.iter().chain([&damper.command]) {
            assert!(parameter.min <= parameter.default && parameter.default <= parameter.max, "{}", parameter.name);
            assert!(!parameter.doc.is_empty() && parameter.min < parameter.max, "{}", parameter.name);
        }
        let made = damper.damper(&damper.defaults()).unwrap();
        assert_eq!(made.states(), damper.state.len());
        assert!(damper.damper(&damper.defaults_on_gear()).unwrap().coefficients(1.0).preload == 0.0, "{}", damper.name);
        for (name, _) in damper.on_gear {
            assert!(damper.parameters.iter().any(|parameter| parameter.name == *name));
        }
    }
    assert_eq!(damper::named("bouc-wenn").unwrap_err().suggestion, Some("bouc-wen"));
}

#[test]
fn what_would_feed_energy_in_is_refused_by_name() {
    for damper in damper::list() {
        let field = |changes: &[(&str, f64)]| refused(damper, changes).unwrap_or_default();
        assert_eq!(field(&[("gamma", -1.0)]), "gamma");
        assert_eq!(field(&[("beta", -1e9)]), "beta");
        assert_eq!(field(&[("amplitude", 0.0)]), "amplitude");
        assert_eq!(field(&[("exponent", 0.5)]), "exponent");
    }
    let simple = damper::named("bouc-wen").unwrap();
    assert_eq!(refused(simple, &[("hysteresisGain", -1.0)]).unwrap(), "hysteresisGain");
    let modified = damper::named("modified-bouc-wen").unwrap();
    for name in ["viscousDampingSlope", "seriesDampingBase", "stiffness", "accumulatorStiffness", "hysteresisGainBase"]
    {
        assert_eq!(refused(modified, &[(name, -1.0)]).unwrap(), name);
    }
    assert!(refused(modified, &[("viscousDampingBase", 0.0), ("seriesDampingBase", 0.0)]).is_some());
    let cubic = damper::named("modified-bouc-wen-cubic").unwrap();
    assert_eq!(refused(cubic, &[("seriesDampingBase", -2.8e6)]), None);
    assert_eq!(refused(cubic, &[("seriesDampingBase", -4e6)]).unwrap(), "seriesDampingBase");
    let dependent = damper::named("current-dependent-bouc-wen").unwrap();
    assert_eq!(
        refused(dependent, &[("stiffnessSlope", -1.0), ("stiffnessSaturation", 0.0)]).unwrap(),
        "stiffnessSlope",
        "it falls for ever"
    );
    assert_eq!(refused(dependent, &[("stiffnessSlope", -1.0), ("stiffnessSaturation", 1.0)]), None);
    assert_eq!(refused(dependent, &[("hysteresisGainSaturation", -1.0)]).unwrap(), "hysteresisGainSaturation");
}

#[test]
fn a_command_outside_of_the_model_is_refused() {
    for (name, low, high) in [
        ("bouc-wen", 0.0, 100.0),
        ("modified-bouc-wen", 0.0, 100.0),
        ("modified-bouc-wen-cubic", 0.06, 2.5),
        ("current-dependent-bouc-wen", 0.0, 100.0),
    ] {
        let damper = damper::named(name).unwrap();
        assert!(damper.check_command(low).is_ok() && damper.check_command(high).is_ok(), "{name}");
        for command in [low - 0.01, f64::NAN, f64::INFINITY] {
            assert_eq!(damper.check_command(command).unwrap_err().field, "command", "{name}");
        }
    }
    assert!(damper::named("modified-bouc-wen-cubic").unwrap().check_command(2.6).is_err());
}

#[test]
fn the_published_numbers_have_their_known_yield_force() {
    // By hand: √(301/7.26e6) m = 6.439 mm, and 14,000 N/m times that is 90.1 N.
    let spencer = damper::named("modified-bouc-wen").unwrap();
    let damper = spencer.damper(&spencer.defaults()).unwrap();
    let most = damper.hysteresis().saturation();
    assert!((most - 6.439e-3).abs() < 5e-7);
    assert!((damper.coefficients(0.0).hysteresis_gain * most - 90.1).abs() < 0.05);
    // Polynomials of the 200 kN damper at 1 A, summed by hand.
    let yang = damper::named("modified-bouc-wen-cubic").unwrap();
    let at = yang.damper(&yang.defaults()).unwrap().coefficients(1.0);
    assert_eq!(at.hysteresis_gain, 112_935.0);
    assert_eq!(at.viscous, 990_807.0);
    assert_eq!(at.series, 41_968_085.0);
}
