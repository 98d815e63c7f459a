using System;

namespace Nowpose.Latency
{
    /// <summary>A control time as 8×8 lights, which a camera can read: whole milliseconds in Gray code, with parity.</summary>
    /// <remarks>
    /// The visible light communication of Schnierle &amp; Röck 2022, Fig. 9. Row 0 is the top, column 0 the left one. The outer ring of
    /// 28 cells is lit but for marks that tell which way is up and who shows the code. The inner 6×6 cells are 18 pairs of
    /// neighbours, three in a row, of which one is lit and one dark: the left one for a 1, the right one for a 0. So what else is in
    /// the picture, and how bright it is, cancels out, and a pair that is covered reads as neither. In reading order the pairs
    /// carry g15 … g0, the Gray code g = b ^ (b >> 1) of the time's whole milliseconds modulo 65 536, then the parity of the
    /// bits with even index, then of those with odd index; both make the number of ones even.
    /// From one millisecond to the next one Gray bit and one parity bit change, so that an exposure over several
    /// milliseconds blurs few pairs.
    /// </remarks>
    static class TimestampCode
    {
        /// <summary>Cells along one side.</summary>
        public const int Side = 8;

        /// <summary>Cells in all, row by row.</summary>
        public const int CellCount = Side * Side;

        /// <summary>Bits of the time.</summary>
        public const int ValueBits = 16;

        /// <summary>Pairs of cells: the time's bits and two of parity.</summary>
        public const int PairCount = ValueBits + 2;

        /// <summary>After so many milliseconds the codes repeat.</summary>
        public const int PeriodMs = 1 << ValueBits;

        const int PairsPerRow = 3;
        const int EvenBits = 0x5555, OddBits = 0xAAAA;

        /// <summary>The time that is coded: whole milliseconds, cut off, modulo <see cref="PeriodMs"/>.</summary>
        public static int ValueOf(ControlTime time)
        {
            var milliseconds = Math.DivRem(time.SinceEpoch.Ticks, TimeSpan.TicksPerMillisecond, out var rest);
            if (rest < 0) milliseconds--;
            return (int)(milliseconds & (PeriodMs - 1));
        }

        /// <summary>How much later the first of two coded times is, from minus half a period to half a period, ms.</summary>
        public static int Difference(int later, int earlier) => (short)(later - earlier);

        /// <summary>The bits of a code's pairs, the first pair's as the highest: Gray code, then the two of parity.</summary>
        /// <param name="value">0 to <see cref="PeriodMs"/> − 1.</param>
        public static int WordOf(int value)
        {
            if (value < 0 || value >= PeriodMs) throw new ArgumentOutOfRangeException(nameof(value), value, "a coded time must be 0 to 65535 ms");
            var gray = value ^ (value >> 1);
            return gray << 2 | Parity(gray & EvenBits) << 1 | Parity(gray & OddBits);
        }

        /// <summary>Cell of a pair that is lit for a 1; the one to its right is lit for a 0.</summary>
        /// <param name="pair">0 to <see cref="PairCount"/> − 1 in reading order.</param>
        public static int CellOf(int pair) => (1 + pair / PairsPerRow) * Side + 1 + pair % PairsPerRow * 2;

        /// <summary>Whether a cell belongs to the ring.</summary>
        public static bool IsRing(int cell)
        {
            int row = cell / Side, column = cell % Side;
            return row == 0 || row == Side - 1 || column == 0 || column == Side - 1;
        }

        /// <summary>
        /// Whether a cell of the ring is lit. Dark are the two behind the top left corner, clockwise, and for the headset also the two
        /// behind the top right one; so no code, turned or mirrored, looks like another.
        /// </summary>
        public static bool IsLitRing(int cell, CodeKind kind)
        {
            int row = cell / Side, column = cell % Side;
            if (row == 0 && (column == 1 || column == 2)) return false;
            return kind == CodeKind.Control || column != Side - 1 || row != 1 && row != 2;
        }

        /// <summary>Which cells are lit.</summary>
        /// <param name="value">0 to <see cref="PeriodMs"/> − 1.</param>
        /// <param name="cells"><see cref="CellCount"/> cells, row by row; all are written.</param>
        public static void Draw(int value, CodeKind kind, Span<bool> cells)
        {
            if (cells.Length != CellCount) throw new ArgumentException("a code has 64 cells, not " + cells.Length, nameof(cells));
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
