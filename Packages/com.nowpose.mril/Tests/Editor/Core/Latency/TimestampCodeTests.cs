using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class TimestampCodeTests
    {
        static bool[] Drawn(int value, CodeKind kind = CodeKind.Control)
        {
            var cells = new bool[TimestampCode.CellCount];
            TimestampCode.Draw(value, kind, cells);
            return cells;
        }

        static string Picture(bool[] cells) => string.Join("/", Enumerable.Range(0, TimestampCode.Side)
            .Select(row => string.Concat(Enumerable.Range(0, TimestampCode.Side).Select(column => cells[row * TimestampCode.Side + column] ? '#' : '.'))));

        static int Ones(int bits) => Convert.ToString(bits, 2).Count(bit => bit == '1');

        [Test]
        public void Draw_KnownTime_LightsTheExpectedCells()
        {
            // 5 is 101 in binary and 111 in Gray code (g2 g1 g0). Both bits with an even index are 1, so their parity is 0. The only bit with an
            // odd index, g1, is 1, so its parity is 1.
            const string expected = "#..#####/#.#.#.##/#.#.#.##/#.#.#.##/#.#.#.##/#.##.#.#/##..##.#/########";

            Assert.That(Picture(Drawn(5)), Is.EqualTo(expected));
        }

        [Test]
        public void ValueOf_AnyTime_ReturnsWholeMillisecondsModuloThePeriod(
            [Values(0, 1, 65_535, 65_536, 1_700_000_000_123, -1)] long milliseconds, [Values(0, 9_999)] long ticksMore)
        {
            var time = new ControlTime(TimeSpan.FromTicks(milliseconds * TimeSpan.TicksPerMillisecond + ticksMore));

            Assert.That(TimestampCode.ValueOf(time), Is.EqualTo((int)((milliseconds % 65_536 + 65_536) % 65_536)));
        }

        [Test]
        public void WordOf_NextMillisecond_DiffersInOneGrayBitAndOneParityBit()
        {
            for (var value = 0; value < TimestampCode.PeriodMs; value++)
            {
                var changed = TimestampCode.WordOf(value) ^ TimestampCode.WordOf((value + 1) % TimestampCode.PeriodMs);

                Assert.That(Ones(changed >> 2) == 1 && Ones(changed & 3) == 1, Is.True, "from " + value);
            }
        }

        [Test]
        public void WordOf_AnyTwoTimes_DifferInAtLeastTwoPairs()
        {
            var words = new HashSet<int>(Enumerable.Range(0, TimestampCode.PeriodMs).Select(TimestampCode.WordOf));

            Assert.That(words.Count, Is.EqualTo(TimestampCode.PeriodMs));
            foreach (var word in words)
                for (var bit = 0; bit < TimestampCode.PairCount; bit++)
                    if (words.Contains(word ^ 1 << bit)) Assert.Fail("one wrong pair is not detected in word " + word);
        }

        [Test]
        public void Draw_AnyTime_LightsOneCellOfEachPair([Values(CodeKind.Control, CodeKind.Headset)] object kind)
        {
            for (var value = 0; value < TimestampCode.PeriodMs; value += 97)
            {
                var cells = Drawn(value, (CodeKind)kind);

                for (var pair = 0; pair < TimestampCode.PairCount; pair++)
                {
                    var cell = TimestampCode.CellOf(pair);
                    Assert.That(cells[cell] != cells[cell + 1] && !TimestampCode.IsRing(cell) && !TimestampCode.IsRing(cell + 1), Is.True);
                }
            }
        }

        [Test]
        public void Ring_RotatedOrMirrored_DiffersFromAllOtherOrientations()
        {
            var seen = new HashSet<string>();

            foreach (var kind in new[] { CodeKind.Control, CodeKind.Headset })
                foreach (var turned in TurnsAndMirrors(kind))
                    Assert.That(seen.Add(Picture(turned)), Is.True, kind + " " + Picture(turned));
        }

        static IEnumerable<bool[]> TurnsAndMirrors(CodeKind kind)
        {
            var ring = Enumerable.Range(0, TimestampCode.CellCount)
                .Select(cell => TimestampCode.IsRing(cell) && TimestampCode.IsLitRing(cell, kind)).ToArray();
            for (var mirror = 0; mirror < 2; mirror++)
            {
                for (var turn = 0; turn < 4; turn++) yield return ring = Moved(ring, (row, column) => (column, 7 - row));
                ring = Moved(ring, (row, column) => (row, 7 - column));
            }
        }

        static bool[] Moved(bool[] cells, Func<int, int, (int Row, int Column)> to)
        {
            var moved = new bool[cells.Length];
            for (var cell = 0; cell < cells.Length; cell++)
            {
                var (row, column) = to(cell / 8, cell % 8);
                moved[row * 8 + column] = cells[cell];
            }
            return moved;
        }
    }
}
