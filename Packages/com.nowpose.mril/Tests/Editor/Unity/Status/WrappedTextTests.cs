using System.Linq;
using Nowpose.Unity;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class WrappedTextTests
    {
        [TestCase("", "")]
        [TestCase("short", "short")]
        [TestCase("exactly ten", "exactly\nten")]
        [TestCase("ten in all", "ten in all")]
        [TestCase("a word and another", "a word and\nanother")]
        [TestCase("averyverylongword here", "averyveryl\nongword\nhere")]
        [TestCase("so averyverylongword", "so\naveryveryl\nongword")]
        public void Of_Line_IsBrokenBetweenWords(string line, string expected)
        {
            Assert.That(WrappedText.Of(line, 10), Is.EqualTo(expected));
        }

        [Test]
        public void Of_AnyWidth_LosesNothingAndNeverExceedsIt([Range(1, 30)] int width)
        {
            const string line = "sync: no connection could be made because 192.168.0.20:47010 actively refused it, trying again";

            var wrapped = WrappedText.Of(line, width);

            Assert.That(wrapped.Split('\n').Max(l => l.Length), Is.LessThanOrEqualTo(width));
            Assert.That(wrapped.Replace("\n", "").Replace(" ", ""), Is.EqualTo(line.Replace(" ", "")));
        }
    }
}
