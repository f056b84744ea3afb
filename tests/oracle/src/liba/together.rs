//! The functions of `atraj.h`, which compute all quantities in one call.

use super::OURS;
use atraj::capi::a_float;
use atraj::capi::atraj::*;
use support::{Family, Implementation, Real};

/// Our C ABI, evaluated by the state at a time and by a few samples of this time, which must agree.
pub struct Together;

impl Implementation<a_float> for Together {
    fn plan(&self, family: Family, arguments: &[a_float], fields: &mut [a_float]) -> a_float {
        OURS.plan(family, arguments, fields)
    }

    fn evaluate(&self, family: Family, fields: &[a_float], x: a_float) -> [a_float; 4] {
        assert_eq!(fields.len(), family.fields().len());
        let state = state(family, fields.as_ptr(), x);
        for sample in samples(family, fields.as_ptr(), x) {
            for (sampled, single) in sample.into_iter().zip(state) {
                assert!(sampled.same(single), "{family:?} {fields:?} at {x:e}");
            }
        }
        state
    }
}

fn state(family: Family, ctx: *const a_float, x: a_float) -> [a_float; 4] {
    let mut state = [0.0; 4];
    let [p, v, a, j] = state.each_mut().map(|y| y as *mut a_float);
    // SAFETY: `ctx` points to the fields of the family's struct, and each output to a real.
    unsafe {
        match family {
            Family::Bell => atraj_bell_state(ctx.cast(), x, p, v, a, j),
            Family::Trap => atraj_trap_state(ctx.cast(), x, p, v, a),
            Family::Poly3 => atraj_poly3_state(ctx.cast(), x, p, v, a),
            Family::Poly5 => atraj_poly5_state(ctx.cast(), x, p, v, a),
            Family::Poly7 => atraj_poly7_state(ctx.cast(), x, p, v, a, j),
        }
    }
    state
}

/// Three samples of one time. Any time plus -0 is this time.
fn samples(family: Family, ctx: *const a_float, x: a_float) -> [[a_float; 4]; 3] {
    let mut out = [[0.0; 3]; 4];
    let [p, v, a, j] = out.each_mut().map(|y| y.as_mut_ptr());
    // SAFETY: `ctx` points to the fields of the family's struct, and each output to three reals.
    let written = unsafe {
        match family {
            Family::Bell => atraj_bell_sample(ctx.cast(), x, -0.0, 3, p, v, a, j),
            Family::Trap => atraj_trap_sample(ctx.cast(), x, -0.0, 3, p, v, a),
            Family::Poly3 => atraj_poly3_sample(ctx.cast(), x, -0.0, 3, p, v, a),
            Family::Poly5 => atraj_poly5_sample(ctx.cast(), x, -0.0, 3, p, v, a),
            Family::Poly7 => atraj_poly7_sample(ctx.cast(), x, -0.0, 3, p, v, a, j),
        }
    };
    assert_eq!(written, 3);
    std::array::from_fn(|k| out.map(|quantity| quantity[k]))
}
