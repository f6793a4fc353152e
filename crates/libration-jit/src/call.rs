//! Code in memory, and the only unsafe code of this crate: the call.

use memmap2::{Mmap, MmapMut};

use crate::assembly::Assembled;
use crate::{Aligned, StraightLine};

/// The signature of the code: pointers to the slots, the arguments, the constants of the line and the scratch memory.
type Function = unsafe extern "sysv64" fn(
    places: *mut f64,
    arguments: *const f64,
    numbers: *const f64,
    scratch: *mut f64,
);

/// Assembled code that can be called.
#[derive(Debug)]
pub(crate) struct Code {
    memory: Mmap,
    /// The constants of the line, each repeated for every lane of a register.
    numbers: Aligned,
    places: usize,
    arguments: usize,
    scratch: usize,
    lanes: usize,
    /// Number of lanes in a register.
    width: usize,
}

impl Code {
    /// Maps the code into executable memory; `None` if the system grants none.
    pub(crate) fn new(line: &StraightLine, assembled: Assembled, width: usize, lanes: usize) -> Option<Self> {
        let Assembled { code, numbers, scratch } = assembled;
        let mut memory = MmapMut::map_anon(code.len()).ok()?;
        memory.copy_from_slice(&code);
        let memory = memory.make_exec().ok()?;
        let mut in_lanes = Aligned::zeros(numbers.len() * width);
        for (lanes, number) in in_lanes.numbers_mut().chunks_mut(width).zip(numbers) {
            lanes.fill(number);
        }
        let (places, arguments) = (line.places(), line.arguments());
        Some(Self { memory, numbers: in_lanes, places, arguments, scratch, lanes, width })
    }

    pub(crate) fn run(&self, places: &mut [f64], arguments: &[f64], scratch: &mut Aligned) {
        let Self { memory, numbers, width, lanes, .. } = self;
        let places = &mut places[..self.places * lanes];
        let arguments = &arguments[..self.arguments * lanes];
        if scratch.numbers().len() < self.scratch {
            *scratch = Aligned::zeros(self.scratch);
        }
        let scratch = scratch.numbers_mut();
        for first in (0..*lanes).step_by(*width) {
            // SAFETY: the memory holds a whole function of this type. It reads and writes `width` numbers from each of the `places`, reads
            // `width` numbers from each of the `arguments`, `lanes` numbers apart, and from each of the `numbers`, and reads and writes
            // `scratch`; it touches no other memory, since the line it was assembled from names no other slots, and the slices have the lengths
            // that the line needs. The first lane is a multiple of the width below `lanes`, itself a multiple of the width. The function changes
            // no register that it must preserve, and the processor has the instructions, as `InstructionSet` checked.
            #[expect(unsafe_code, reason = "calling code that was made at run time")]
            unsafe {
                let function: Function = std::mem::transmute(memory.as_ptr());
                function(
                    places.as_mut_ptr().add(first),
                    arguments.as_ptr().add(first),
                    numbers.numbers().as_ptr(),
                    scratch.as_mut_ptr(),
                );
            }
        }
    }
}
