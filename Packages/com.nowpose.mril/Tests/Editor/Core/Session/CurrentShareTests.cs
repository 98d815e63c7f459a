using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class CurrentShareTests
    {
        // Adds frames at 60 Hz. The first frame is at the time "from" in s.
        static void Add(CurrentShare share, double from, double seconds, bool isCurrent)
        {
            for (var i = 0; i < seconds * 60; i++) share.Add(HeadsetTime.FromSeconds(from + i / 60.0), isCurrent);
        }

        [Test]
        public void Value_WithoutFrames_IsNull() => Assert.That(new CurrentShare().Value, Is.Null);

        [TestCase(-20)]
        [TestCase(0)]
        [TestCase(1e6)]
        public void Value_RunShorterThanTheWindow_IsTheShareOfAllFrames(double start)
        {
            var share = new CurrentShare();
            Add(share, start, 3, false);
            Add(share, start + 3, 1, true);

            Assert.That(share.Value, Is.EqualTo(0.25).Within(1e-12));
        }

        [Test]
        public void Value_LongRun_CoversTheLastTenSeconds()
        {
            var share = new CurrentShare();
            Add(share, 0, 60, false);
            Add(share, 60, 4, true);
            var after4 = share.Value;
            Add(share, 64, 6, true);

            Assert.That(after4, Is.EqualTo(0.4).Within(1e-12));
            Assert.That(share.Value, Is.EqualTo(1));
        }

        [Test]
        public void Value_AfterAPauseOfTheDisplay_CoversOnlyLaterFrames()
        {
            var share = new CurrentShare();
            Add(share, 0, 10, true);
            Add(share, 35, 0.5, false);

            Assert.That(share.Value, Is.EqualTo(0));
        }
    }
}
