//! Two axes under RTIC: the idle task plans, and the interrupt of a timer gives the setpoints. The axes go to a part on a line, stand in a feed
//! hold, and go on. On the way back they are stopped, and then go home. There is no heap, and no `unsafe`.
//!
//! It runs in QEMU, on the Cortex-M3 of an LM3S6965:
//!
//! ```sh
//! rustup target add thumbv7m-none-eabi
//! cd examples/rtic && cargo run --release
//! ```

#![no_std]
#![no_main]
#![deny(unsafe_code)]

use core::panic::PanicInfo;
use cortex_m_semihosting::{debug, hprintln};

#[rtic::app(device = lm3s6965)]
mod app {
    use atraj::machine::{Group, GroupPlanner, GroupTicker};
    use atraj::online::{Error, Limits, Move, State};
    use cortex_m::asm::wfi;
    use cortex_m::peripheral::syst::SystClkSource;
    use cortex_m_semihosting::{debug, hprintln};
    use rtic::Mutex;

    const AXES: usize = 2;
    const PERIOD: f32 = 0.002; // s
    const CYCLES: u32 = 25_000; // of the timer's clock in a period
    const LEAD: u32 = 40; // ticks: longer than a plan takes here

    /// What the interrupt tells the idle task.
    #[derive(Clone, Copy)]
    pub struct Seen {
        tick: u32,
        stands: bool,
        states: [State<f32>; AXES],
    }

    #[shared]
    struct Shared {
        seen: Seen,
    }

    #[local]
    struct Local {
        planner: GroupPlanner<'static, 'static, f32>,
        ticker: GroupTicker<'static, 'static, f32>,
    }

    // RTIC keeps these for the whole run, so the halves of the group may go to tasks.
    #[init(local = [
        memory: Option<([State<f32>; AXES], [Move<f32>; 3 * AXES])> = None,
        group: Option<Group<'static, f32>> = None,
    ])]
    fn init(cx: init::Context) -> (Shared, Local) {
        let states = [State::at(0.0); AXES];
        let (start, moves) = cx.local.memory.insert((states, [Move::default(); 3 * AXES]));
        let group = cx.local.group.insert(Group::new(PERIOD, start, moves).unwrap());
        let (planner, ticker) = group.split();

        let mut timer = cx.core.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(CYCLES - 1);
        timer.clear_current();
        timer.enable_interrupt();
        timer.enable_counter();
        (Shared { seen: Seen { tick: 0, stands: true, states } }, Local { planner, ticker })
    }

    #[task(binds = SysTick, local = [ticker], shared = [seen])]
    fn tick(mut cx: tick::Context) {
        cx.shared.seen.lock(|seen| {
            let new = cx.local.ticker.tick(&mut seen.states); // here the drives get the states
            seen.tick += 1;
            seen.stands = new.ends || seen.stands && !new.begins;
        });
    }

    #[idle(local = [planner], shared = [seen])]
    fn idle(mut cx: idle::Context) -> ! {
        let done = work(cx.local.planner, &mut cx.shared.seen);
        if let Err(error) = done {
            hprintln!("{}", error);
        }
        debug::exit(if done.is_ok() { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
        loop {
            wfi();
        }
    }

    fn work(planner: &mut GroupPlanner<f32>, seen: &mut impl Mutex<T = Seen>) -> Result<(), Error> {
        // Jerk, acceleration, velocity.
        let limits = [Limits::symmetric(20.0, 4.0, 1.0); AXES];
        let planned = [Limits::symmetric(0.85 * 20.0, 0.85 * 4.0, 0.85 * 1.0); AXES];
        let [part, home] = [[0.8, -0.4], [0.0, 0.0]].map(|positions| positions.map(State::at)); // m
        hprintln!("Two axes under RTIC: line, hold, stop");

        planner.line(&planned, &part, LEAD)?;
        let on_the_line = at(seen, 250);
        planner.rate(&limits, 0.0, LEAD)?;
        say("feed hold", &on_the_line);
        say("held", &at_end(seen));
        let still_held = at(seen, 750);
        // The rest of a line is a line. `rate(&limits, 1.0, …)` goes on along any path, but takes long without a floating-point unit.
        planner.line(&planned, &part, LEAD)?;
        say("go on", &still_held);
        say("at the part", &at_end(seen));

        planner.line(&planned, &home, LEAD)?;
        let on_the_way_back = at(seen, 1500);
        planner.stop(&limits, LEAD)?;
        say("stop", &on_the_way_back);
        say("stopped", &at_end(seen));
        planner.line(&planned, &home, LEAD)?;
        say("at home", &at_end(seen));
        Ok(())
    }

    /// Sleeps from interrupt to interrupt until this tick.
    fn at(seen: &mut impl Mutex<T = Seen>, tick: u32) -> Seen {
        wait(seen, |seen| seen.tick >= tick)
    }

    /// Sleeps until the motion that was planned last is at its end.
    fn at_end(seen: &mut impl Mutex<T = Seen>) -> Seen {
        let takeover = seen.lock(|seen| seen.tick) + LEAD; // at the latest
        wait(seen, |seen| seen.tick >= takeover && seen.stands)
    }

    fn wait(seen: &mut impl Mutex<T = Seen>, for_this: impl Fn(&Seen) -> bool) -> Seen {
        loop {
            let now = seen.lock(|seen| *seen);
            if for_this(&now) {
                return now;
            }
            wfi();
        }
    }

    fn say(what: &str, Seen { tick, states: [a, b], .. }: &Seen) {
        let time = *tick as f32 * PERIOD;
        hprintln!("{:.3} s: {:.4} {:.4} m, {}", time, a.position, b.position, what);
    }
}

#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    hprintln!("{}", info);
    debug::exit(debug::EXIT_FAILURE);
    loop {}
}
