using System;

namespace Nowpose.Latency
{
    /// <summary>Clock that a code shows. Marks in the ring distinguish the two codes of a picture.</summary>
    enum CodeKind
    {
        /// <summary>Shown by the control system, on LEDs or on a monitor: C1(t_VLC) of Eq. (7).</summary>
        Control,

        /// <summary>Shown by the headset as a hologram: C2(t_MR) of Eq. (7), mapped to the control clock.</summary>
        Headset,
    }

    /// <summary>Encodes a control time in 8×8 lights that a camera can read: whole milliseconds in Gray code, with parity.</summary>
    /// <remarks>
    /// Implements the visible light communication of Schnierle &amp; Röck 2022, Fig. 9. Row 0 is at the top, column 0 on the left. The 28
    /// cells of the outer ring are lit except for marks that show the orientation and the <see cref="CodeKind"/>. The inner 6×6 cells are 18
    /// pairs of neighbours, three in a row, with one cell lit and one dark: the left cell is lit for a 1, the right cell for a 0. The
    /// comparison within a pair cancels brightness and background, and a covered pair is recognised as unreadable. In reading order
    /// the pairs carry g15 … g0, the Gray code g = b ^ (b >> 1) of the time's whole milliseconds modulo 65 536, then the parity of the bits
    /// with even index, and then the parity of the bits with odd index (even parity: the number of ones is even).
    /// From one millisecond to the next, one Gray bit and one parity bit change, so an exposure of several milliseconds blurs only a few pairs.
    /// </remarks>
    static class TimestampCode
    {
        /// <summary>Number of cells along one side.</summary>
        public const int Side = 8;

        /// <summary>Total number of cells, in row-major order.</summary>
        public const int CellCount = Side * Side;

        /// <summary>Number of bits of the time.</summary>
        public const int ValueBits = 16;

        /// <summary>Number of pairs: one for each bit of the time and two for parity.</summary>
        public const int PairCount = ValueBits + 2;

        /// <summary>Period after which the codes repeat, in ms.</summary>
        public const int PeriodMs = 1 << ValueBits;

        /// <summary>Number of pairs in one row; rows follow each other in reading order.</summary>
        public const int PairsPerRow = 3;

        const int EvenBits = 0x5555, OddBits = 0xAAAA;

        /// <summary>Returns the value to encode: whole milliseconds, rounded down, modulo <see cref="PeriodMs"/>.</summary>
        public static int ValueOf(ControlTime time)
        {
            var milliseconds = Math.DivRem(time.SinceEpoch.Ticks, TimeSpan.TicksPerMillisecond, out var rest);
            if (rest < 0) milliseconds--;
            return (int)(milliseconds & (PeriodMs - 1));
        }

        /// <summary>Returns the bits of all pairs, first pair in the highest bit: Gray code, then the two parity bits.</summary>
        /// <param name="value">0 to <see cref="PeriodMs"/> − 1.</param>
        public static int WordOf(int value)
        {
            var gray = value ^ (value >> 1);
            return gray << 2 | Parity(gray & EvenBits) << 1 | Parity(gray & OddBits);
        }

        /// <summary>Returns the cell of a pair that is lit for a 1; the cell to its right is lit for a 0.</summary>
        /// <param name="pair">0 to <see cref="PairCount"/> − 1 in reading order.</param>
        public static int CellOf(int pair) => (1 + pair / PairsPerRow) * Side + 1 + pair % PairsPerRow * 2;

        /// <summary>Returns whether a cell belongs to the ring.</summary>
        public static bool IsRing(int cell)
        {
            int row = cell / Side, column = cell % Side;
            return row == 0 || row == Side - 1 || column == 0 || column == Side - 1;
        }

        /// <summary>
        /// Returns whether a cell of the ring is lit. The two cells that follow the top left corner clockwise are dark; for the headset, the two
        /// cells that follow the top right corner are dark, too. No rotation or reflection of one code matches another.
        /// </summary>
        public static bool IsLitRing(int cell, CodeKind kind)
        {
            int row = cell / Side, column = cell % Side;
            if (row == 0 && (column == 1 || column == 2)) return false;
            return kind == CodeKind.Control || column != Side - 1 || row != 1 && row != 2;
        }

        /// <summary>Computes which cells are lit.</summary>
        /// <param name="value">0 to <see cref="PeriodMs"/> − 1.</param>
        /// <param name="cells">Receives <see cref="CellCount"/> cells in row-major order; all are written.</param>
        public static void Draw(int value, CodeKind kind, Span<bool> cells)
        {
            var word = WordOf(value);
            for (var cell = 0; cell < CellCount; cell++) cells[cell] = IsRing(cell) && IsLitRing(cell, kind);
            for (var pair = 0; pair < PairCount; pair++)
            {
                var isOne = (word >> (PairCount - 1 - pair) & 1) != 0;
                cells[CellOf(pair)] = isOne;
                cells[CellOf(pair) + 1] = !isOne;
            }
        }

        static int Parity(int bits)
        {
            bits ^= bits >> 8;
            bits ^= bits >> 4;
            bits ^= bits >> 2;
            return (bits ^ bits >> 1) & 1;
        }
    }
}
