using System;
using System.Globalization;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Status
{
    public class NumberTextsTests
    {
        static readonly NumberTexts Texts = new NumberTexts("± ", " ms", (2, 1, 0));

        [TestCase(0, "± 0.00 ms")]
        [TestCase(0.004, "± 0.00 ms")]
        [TestCase(0.35, "± 0.35 ms")]
        [TestCase(0.994, "± 0.99 ms")]
        [TestCase(0.996, "± 1.0 ms")]
        [TestCase(83.44, "± 83.4 ms")]
        [TestCase(99.96, "± 100 ms")]
        [TestCase(999.4, "± 999 ms")]
        [TestCase(999.6, "± > 999 ms")]
        [TestCase(1e300, "± > 999 ms")]
        [TestCase(double.PositiveInfinity, "± > 999 ms")]
        [TestCase(-0.4, "± 0.00 ms")]
        [TestCase(-0.6, "± −1 ms")]
        [TestCase(-12.3, "± −12 ms")]
        [TestCase(-5000, "± < −999 ms")]
        [TestCase(double.NegativeInfinity, "± < −999 ms")]
        [TestCase(double.NaN, "–")]
        public void Of_Number_IsRoundedToReadableDigits(double number, string expected)
        {
            Assert.That(Texts.Of(number), Is.EqualTo(expected));
        }

        [Test]
        public void Of_Unknown_ReturnsADash()
        {
            Assert.That(Texts.Of((double?)null), Is.EqualTo("–"));
            Assert.That(Texts.Of((TimeSpan?)null), Is.EqualTo("–"));
        }

        [Test]
        public void Of_TimeSpan_IsInMilliseconds()
        {
            Assert.That(Texts.Of(TimeSpan.FromTicks(12_340)), Is.EqualTo("± 1.2 ms"));
        }

        [Test]
        public void Of_RandomNumbers_AreRoundedToTheNearest()
        {
            var random = new Random(1);
            for (var i = 0; i < 10_000; i++)
            {
                var number = Math.Pow(10, random.NextDouble() * 5 - 2.1);
                if (number >= 999.5) continue;
                var shown = double.Parse(Texts.Of(number).Substring(2).Replace(" ms", ""), CultureInfo.InvariantCulture);

                Assert.That(shown, Is.EqualTo(number).Within(Math.Max(0.00501, number < 99.95 ? 0.0501 : 0.501)), "seed 1, number " + number);
            }
        }

        [Test]
        public void Of_SameNumberTwice_ReusesTheString()
        {
            Assert.That(Texts.Of(12.34), Is.SameAs(Texts.Of(12.31)), "the texts are created in advance");
        }
    }
}
