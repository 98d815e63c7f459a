using System.Linq;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Status
{
    public class WrappedTextTests
    {
        // Letter widths in font sizes: digit 0.556, space 0.278, W 0.944.
        [TestCase("", "")]
        [TestCase("000", "000")]
        [TestCase("000 000", "000 000")]
        [TestCase("000 0000", "000\n0000")]
        [TestCase("000 000 000", "000 000\n000")]
        [TestCase("WWWW iiii", "WWWW\niiii")]
        [TestCase("00000000 00", "0000000\n0 00")]
        [TestCase("00 00000000", "00\n0000000\n0")]
        public void Of_Line_IsWrappedBetweenWordsByWidth(string line, string expected)
        {
            Assert.That(WrappedText.Of(line, 4), Is.EqualTo(expected));
        }

        [TestCase("000 000 000", 2, "000 000\n000")]
        [TestCase("000 000 000", 1, "000 0…")]
        [TestCase("00 0000 000 000 0", 2, "00 0000\n000 0…")]
        [TestCase("000 000", 1, "000 000")]
        public void Of_TooManyLines_EndsWithAnEllipsis(string line, int lines, string expected)
        {
            Assert.That(WrappedText.Of(line, 4, lines), Is.EqualTo(expected));
        }

        [Test]
        public void Of_AnyWidth_KeepsAllTextWithinTheWidth([Range(2, 30)] int width)
        {
            const string line = "sync: no connection could be made because 192.168.0.20:47010 actively refused it, trying again";

            var wrapped = WrappedText.Of(line, width);

            Assert.That(wrapped.Split('\n').Max(l => LetterWidths.Of(l)), Is.LessThanOrEqualTo(width));
            Assert.That(wrapped.Replace("\n", "").Replace(" ", ""), Is.EqualTo(line.Replace(" ", "")));
        }
    }
}
