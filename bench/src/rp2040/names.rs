//! Names of peripherals and registers, for errors that people read.
//!
//! Owns no behaviour. Source: RP2040 datasheet, the register list of each chapter.

/// The external interrupts by number (datasheet 2.3.2); 26 to 31 are wired to nothing, software may pend them.
pub(super) const IRQS: [&str; 32] = [
    "TIMER_IRQ_0",
    "TIMER_IRQ_1",
    "TIMER_IRQ_2",
    "TIMER_IRQ_3",
    "PWM_IRQ_WRAP",
    "USBCTRL_IRQ",
    "XIP_IRQ",
    "PIO0_IRQ_0",
    "PIO0_IRQ_1",
    "PIO1_IRQ_0",
    "PIO1_IRQ_1",
    "DMA_IRQ_0",
    "DMA_IRQ_1",
    "IO_IRQ_BANK0",
    "IO_IRQ_QSPI",
    "SIO_IRQ_PROC0",
    "SIO_IRQ_PROC1",
    "CLOCKS_IRQ",
    "SPI0_IRQ",
    "SPI1_IRQ",
    "UART0_IRQ",
    "UART1_IRQ",
    "ADC_IRQ_FIFO",
    "I2C0_IRQ",
    "I2C1_IRQ",
    "RTC_IRQ",
    "SW0_IRQ",
    "SW1_IRQ",
    "SW2_IRQ",
    "SW3_IRQ",
    "SW4_IRQ",
    "SW5_IRQ",
];

/// The peripheral at `address`, or a description of the region.
pub(super) fn peripheral(address: u32) -> &'static str {
    const APB: [&str; 28] = [
        "SYSINFO",
        "SYSCFG",
        "CLOCKS",
        "RESETS",
        "PSM",
        "IO_BANK0",
        "IO_QSPI",
        "PADS_BANK0",
        "PADS_QSPI",
        "XOSC",
        "PLL_SYS",
        "PLL_USB",
        "BUSCTRL",
        "UART0",
        "UART1",
        "SPI0",
        "SPI1",
        "I2C0",
        "I2C1",
        "ADC",
        "PWM",
        "TIMER",
        "WATCHDOG",
        "RTC",
        "ROSC",
        "VREG_AND_CHIP_RESET",
        "(reserved)",
        "TBMAN",
    ];
    match address >> 20 {
        0x140 => "XIP_CTRL",
        0x150 => "XIP_SRAM",
        0x180 => "XIP_SSI",
        0x400 => APB.get((address >> 14 & 0x3f) as usize).copied().unwrap_or("APB"),
        0x500 => "DMA",
        0x501 if address & 0x1_0000 == 0 => "USBCTRL_DPRAM",
        0x501 => "USBCTRL_REGS",
        0x502 => "PIO0",
        0x503 => "PIO1",
        0xd00 => "SIO",
        _ => "memory map",
    }
}

const I2C: [(u32, &str); 16] = [
    (0x00, "IC_CON"),
    (0x04, "IC_TAR"),
    (0x08, "IC_SAR"),
    (0x10, "IC_DATA_CMD"),
    (0x14, "IC_SS_SCL_HCNT"),
    (0x18, "IC_SS_SCL_LCNT"),
    (0x1c, "IC_FS_SCL_HCNT"),
    (0x20, "IC_FS_SCL_LCNT"),
    (0x2c, "IC_INTR_STAT"),
    (0x30, "IC_INTR_MASK"),
    (0x34, "IC_RAW_INTR_STAT"),
    (0x38, "IC_RX_TL"),
    (0x3c, "IC_TX_TL"),
    (0x40, "IC_CLR_INTR"),
    (0x6c, "IC_ENABLE"),
    (0x70, "IC_STATUS"),
];
const RTC: [(u32, &str); 12] = [
    (0x00, "CLKDIV_M1"),
    (0x04, "SETUP_0"),
    (0x08, "SETUP_1"),
    (0x0c, "CTRL"),
    (0x10, "IRQ_SETUP_0"),
    (0x14, "IRQ_SETUP_1"),
    (0x18, "RTC_1"),
    (0x1c, "RTC_0"),
    (0x20, "INTR"),
    (0x24, "INTE"),
    (0x28, "INTF"),
    (0x2c, "INTS"),
];
const PIO: [(u32, &str); 11] = [
    (0x00, "CTRL"),
    (0x04, "FSTAT"),
    (0x08, "FDEBUG"),
    (0x0c, "FLEVEL"),
    (0x10, "TXF0"),
    (0x20, "RXF0"),
    (0x30, "IRQ"),
    (0x34, "IRQ_FORCE"),
    (0x38, "INPUT_SYNC_BYPASS"),
    (0x48, "INSTR_MEM0"),
    (0xc8, "SM0_CLKDIV"),
];
const USB: [(u32, &str); 12] = [
    (0x00, "ADDR_ENDP"),
    (0x40, "MAIN_CTRL"),
    (0x4c, "SIE_CTRL"),
    (0x50, "SIE_STATUS"),
    (0x54, "INT_EP_CTRL"),
    (0x58, "BUFF_STATUS"),
    (0x74, "USB_MUXING"),
    (0x78, "USB_PWR"),
    (0x8c, "INTR"),
    (0x90, "INTE"),
    (0x94, "INTF"),
    (0x98, "INTS"),
];
const SIO: [(u32, &str); 6] = [
    (0x54, "FIFO_WR (core 1)"),
    (0x58, "FIFO_RD (core 1)"),
    (0x80, "INTERP0_ACCUM0"),
    (0xac, "INTERP0_CTRL_LANE0"),
    (0xc0, "INTERP1_ACCUM0"),
    (0xec, "INTERP1_CTRL_LANE0"),
];

/// `PERIPHERAL.REGISTER`, or `PERIPHERAL + offset` where the register has no entry here.
pub(super) fn register(address: u32) -> String {
    let name = peripheral(address);
    let (offset, table): (u32, &[(u32, &str)]) = match name {
        "I2C0" | "I2C1" => (address & 0xfff, &I2C),
        "RTC" => (address & 0xfff, &RTC),
        "PIO0" | "PIO1" => (address & 0xfff, &PIO),
        "USBCTRL_REGS" => (address & 0xfff, &USB),
        "SIO" => (address & 0xfff, &SIO),
        "USBCTRL_DPRAM" => (address & 0xffff, &[]),
        _ => (address & 0xfff, &[]),
    };
    match table.iter().find(|(at, _)| *at == offset & !3) {
        Some((_, register)) => format!("{name}.{register}"),
        None => format!("{name} + {offset:#x}"),
    }
}
