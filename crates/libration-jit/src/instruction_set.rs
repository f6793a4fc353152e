//! The instructions for one, four and eight lanes in a register.

use iced_x86::{Code, Register};

/// The instructions for each operation.
#[derive(Debug)]
pub(crate) struct InstructionSet {
    /// Number of lanes in a register.
    pub(crate) lanes: usize,
    pub(crate) registers: usize,
    first: Register,
    pub(crate) load: Code,
    pub(crate) store: Code,
    pub(crate) copy: Code,
    pub(crate) add: Code,
    pub(crate) subtract: Code,
    pub(crate) multiply: Code,
    pub(crate) divide: Code,
    pub(crate) multiply_add: Code,
    pub(crate) exclusive_or: Code,
    /// The instruction before the return.
    pub(crate) leave: Code,
    /// Instructions for two, four or eight numbers at once, in a set with one lane.
    pub(crate) packed: Option<PackedSet>,
}

/// Instructions that combine two numbers to a pair, two pairs to four, and two fours to eight, and the arithmetic of each width.
#[derive(Debug)]
pub(crate) struct PackedSet {
    /// Joins the lower numbers of two registers.
    pub(crate) unpack_low: Code,
    /// Moves the higher number down; both operands are the same register.
    pub(crate) unpack_high: Code,
    /// Loads a number from memory above the lower number of a register.
    pub(crate) load_high: Code,
    /// Inserts a pair above another pair.
    pub(crate) insert: Code,
    pub(crate) one: Packed,
    pub(crate) two: Packed,
    pub(crate) four: Packed,
    pub(crate) eight: Option<Eight>,
}

/// Instructions for eight numbers, in sets whose registers hold eight.
#[derive(Debug)]
pub(crate) struct Eight {
    /// Inserts four numbers above four others.
    pub(crate) insert: Code,
    pub(crate) packed: Packed,
}

impl PackedSet {
    /// The largest number of inner products side by side in a register.
    pub(crate) fn widest(&self) -> usize {
        if self.eight.is_some() { 8 } else { 4 }
    }
}

/// Instructions for a register of one, two, four or eight numbers.
#[derive(Debug)]
pub(crate) struct Packed {
    first: Register,
    pub(crate) load: Code,
    pub(crate) store: Code,
    /// The same number in all lanes.
    pub(crate) broadcast: Code,
    pub(crate) add: Code,
    pub(crate) multiply: Code,
    pub(crate) multiply_add: Code,
}

impl Packed {
    pub(crate) fn register(&self, number: usize) -> Register {
        self.first + u32::try_from(number).unwrap_or(u32::MAX)
    }
}

impl InstructionSet {
    /// The instruction sets that the processor has and whose number of lanes divides `lanes`, widest first.
    pub(crate) fn for_lanes(lanes: usize) -> impl Iterator<Item = &'static Self> {
        let is_known = lanes > 0 && is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        let fits = move |set: &&'static Self| {
            lanes.is_multiple_of(set.lanes)
                && (set.lanes > 1 || lanes == 1)
                && (set.registers < EIGHT.registers || has_avx512())
        };
        [&EIGHT, &FOUR, &ONE_OF_32, &ONE].into_iter().filter(move |set| is_known && fits(set))
    }

    /// The size of a register in bytes.
    pub(crate) fn bytes(&self) -> usize {
        self.lanes * size_of::<f64>()
    }

    /// Returns `true` if a displacement of up to 127 times the size of a register is encoded in one byte.
    pub(crate) fn has_short_distances(&self) -> bool {
        self.registers == EIGHT.registers
    }

    pub(crate) fn register(&self, number: usize) -> Register {
        self.first + u32::try_from(number).unwrap_or(u32::MAX)
    }
}

/// Returns `true` if the processor has AVX-512, with which there are twice as many registers.
fn has_avx512() -> bool {
    is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512vl")
}

static ONE: InstructionSet = InstructionSet {
    lanes: 1,
    registers: 16,
    first: Register::XMM0,
    load: Code::VEX_Vmovsd_xmm_m64,
    store: Code::VEX_Vmovsd_m64_xmm,
    copy: Code::VEX_Vmovapd_xmm_xmmm128,
    add: Code::VEX_Vaddsd_xmm_xmm_xmmm64,
    subtract: Code::VEX_Vsubsd_xmm_xmm_xmmm64,
    multiply: Code::VEX_Vmulsd_xmm_xmm_xmmm64,
    divide: Code::VEX_Vdivsd_xmm_xmm_xmmm64,
    multiply_add: Code::VEX_Vfmadd231sd_xmm_xmm_xmmm64,
    exclusive_or: Code::VEX_Vxorpd_xmm_xmm_xmmm128,
    leave: Code::VEX_Vzeroupper,
    packed: Some(PackedSet {
        unpack_low: Code::VEX_Vunpcklpd_xmm_xmm_xmmm128,
        unpack_high: Code::VEX_Vunpckhpd_xmm_xmm_xmmm128,
        load_high: Code::VEX_Vmovhpd_xmm_xmm_m64,
        insert: Code::VEX_Vinsertf128_ymm_ymm_xmmm128_imm8,
        one: Packed {
            first: Register::XMM0,
            load: Code::VEX_Vmovsd_xmm_m64,
            store: Code::VEX_Vmovsd_m64_xmm,
            broadcast: Code::VEX_Vmovsd_xmm_m64,
            add: Code::VEX_Vaddsd_xmm_xmm_xmmm64,
            multiply: Code::VEX_Vmulsd_xmm_xmm_xmmm64,
            multiply_add: Code::VEX_Vfmadd231sd_xmm_xmm_xmmm64,
        },
        two: Packed {
            first: Register::XMM0,
            load: Code::VEX_Vmovupd_xmm_xmmm128,
            store: Code::VEX_Vmovupd_xmmm128_xmm,
            broadcast: Code::VEX_Vmovddup_xmm_xmmm64,
            add: Code::VEX_Vaddpd_xmm_xmm_xmmm128,
            multiply: Code::VEX_Vmulpd_xmm_xmm_xmmm128,
            multiply_add: Code::VEX_Vfmadd231pd_xmm_xmm_xmmm128,
        },
        four: Packed {
            first: Register::YMM0,
            load: Code::VEX_Vmovupd_ymm_ymmm256,
            store: Code::VEX_Vmovupd_ymmm256_ymm,
            broadcast: Code::VEX_Vbroadcastsd_ymm_m64,
            add: Code::VEX_Vaddpd_ymm_ymm_ymmm256,
            multiply: Code::VEX_Vmulpd_ymm_ymm_ymmm256,
            multiply_add: Code::VEX_Vfmadd231pd_ymm_ymm_ymmm256,
        },
        eight: None,
    }),
};

static ONE_OF_32: InstructionSet = InstructionSet {
    lanes: 1,
    registers: 32,
    first: Register::XMM0,
    load: Code::EVEX_Vmovsd_xmm_k1z_m64,
    store: Code::EVEX_Vmovsd_m64_k1_xmm,
    copy: Code::EVEX_Vmovapd_xmm_k1z_xmmm128,
    add: Code::EVEX_Vaddsd_xmm_k1z_xmm_xmmm64_er,
    subtract: Code::EVEX_Vsubsd_xmm_k1z_xmm_xmmm64_er,
    multiply: Code::EVEX_Vmulsd_xmm_k1z_xmm_xmmm64_er,
    divide: Code::EVEX_Vdivsd_xmm_k1z_xmm_xmmm64_er,
    multiply_add: Code::EVEX_Vfmadd231sd_xmm_k1z_xmm_xmmm64_er,
    exclusive_or: Code::EVEX_Vxorpd_xmm_k1z_xmm_xmmm128b64,
    leave: Code::VEX_Vzeroupper,
    packed: Some(PackedSet {
        unpack_low: Code::EVEX_Vunpcklpd_xmm_k1z_xmm_xmmm128b64,
        unpack_high: Code::EVEX_Vunpckhpd_xmm_k1z_xmm_xmmm128b64,
        load_high: Code::EVEX_Vmovhpd_xmm_xmm_m64,
        insert: Code::EVEX_Vinsertf64x2_ymm_k1z_ymm_xmmm128_imm8,
        one: Packed {
            first: Register::XMM0,
            load: Code::EVEX_Vmovsd_xmm_k1z_m64,
            store: Code::EVEX_Vmovsd_m64_k1_xmm,
            broadcast: Code::EVEX_Vmovsd_xmm_k1z_m64,
            add: Code::EVEX_Vaddsd_xmm_k1z_xmm_xmmm64_er,
            multiply: Code::EVEX_Vmulsd_xmm_k1z_xmm_xmmm64_er,
            multiply_add: Code::EVEX_Vfmadd231sd_xmm_k1z_xmm_xmmm64_er,
        },
        two: Packed {
            first: Register::XMM0,
            load: Code::EVEX_Vmovupd_xmm_k1z_xmmm128,
            store: Code::EVEX_Vmovupd_xmmm128_k1z_xmm,
            broadcast: Code::EVEX_Vmovddup_xmm_k1z_xmmm64,
            add: Code::EVEX_Vaddpd_xmm_k1z_xmm_xmmm128b64,
            multiply: Code::EVEX_Vmulpd_xmm_k1z_xmm_xmmm128b64,
            multiply_add: Code::EVEX_Vfmadd231pd_xmm_k1z_xmm_xmmm128b64,
        },
        four: Packed {
            first: Register::YMM0,
            load: Code::EVEX_Vmovupd_ymm_k1z_ymmm256,
            store: Code::EVEX_Vmovupd_ymmm256_k1z_ymm,
            broadcast: Code::EVEX_Vbroadcastsd_ymm_k1z_xmmm64,
            add: Code::EVEX_Vaddpd_ymm_k1z_ymm_ymmm256b64,
            multiply: Code::EVEX_Vmulpd_ymm_k1z_ymm_ymmm256b64,
            multiply_add: Code::EVEX_Vfmadd231pd_ymm_k1z_ymm_ymmm256b64,
        },
        eight: Some(Eight {
            insert: Code::EVEX_Vinsertf64x4_zmm_k1z_zmm_ymmm256_imm8,
            packed: Packed {
                first: Register::ZMM0,
                load: Code::EVEX_Vmovupd_zmm_k1z_zmmm512,
                store: Code::EVEX_Vmovupd_zmmm512_k1z_zmm,
                broadcast: Code::EVEX_Vbroadcastsd_zmm_k1z_xmmm64,
                add: Code::EVEX_Vaddpd_zmm_k1z_zmm_zmmm512b64_er,
                multiply: Code::EVEX_Vmulpd_zmm_k1z_zmm_zmmm512b64_er,
                multiply_add: Code::EVEX_Vfmadd231pd_zmm_k1z_zmm_zmmm512b64_er,
            },
        }),
    }),
};

static FOUR: InstructionSet = InstructionSet {
    lanes: 4,
    registers: 16,
    first: Register::YMM0,
    load: Code::VEX_Vmovupd_ymm_ymmm256,
    store: Code::VEX_Vmovupd_ymmm256_ymm,
    copy: Code::VEX_Vmovapd_ymm_ymmm256,
    add: Code::VEX_Vaddpd_ymm_ymm_ymmm256,
    subtract: Code::VEX_Vsubpd_ymm_ymm_ymmm256,
    multiply: Code::VEX_Vmulpd_ymm_ymm_ymmm256,
    divide: Code::VEX_Vdivpd_ymm_ymm_ymmm256,
    multiply_add: Code::VEX_Vfmadd231pd_ymm_ymm_ymmm256,
    exclusive_or: Code::VEX_Vxorpd_ymm_ymm_ymmm256,
    leave: Code::VEX_Vzeroupper,
    packed: None,
};

static EIGHT: InstructionSet = InstructionSet {
    lanes: 8,
    registers: 32,
    first: Register::ZMM0,
    load: Code::EVEX_Vmovupd_zmm_k1z_zmmm512,
    store: Code::EVEX_Vmovupd_zmmm512_k1z_zmm,
    copy: Code::EVEX_Vmovapd_zmm_k1z_zmmm512,
    add: Code::EVEX_Vaddpd_zmm_k1z_zmm_zmmm512b64_er,
    subtract: Code::EVEX_Vsubpd_zmm_k1z_zmm_zmmm512b64_er,
    multiply: Code::EVEX_Vmulpd_zmm_k1z_zmm_zmmm512b64_er,
    divide: Code::EVEX_Vdivpd_zmm_k1z_zmm_zmmm512b64_er,
    multiply_add: Code::EVEX_Vfmadd231pd_zmm_k1z_zmm_zmmm512b64_er,
    exclusive_or: Code::EVEX_Vxorpd_zmm_k1z_zmm_zmmm512b64,
    leave: Code::VEX_Vzeroupper,
    packed: None,
};
