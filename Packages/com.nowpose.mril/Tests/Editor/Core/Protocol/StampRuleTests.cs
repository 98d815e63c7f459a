using System;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Tests.Core.Protocol
{
    public class StampRuleTests
    {
        static readonly ControlTime Now = ControlTime.FromSeconds(1000);
        static readonly TimeSpan Bound = TimeSpan.FromMilliseconds(20);

        [TestCase(-1e6, false)]
        [TestCase(0, false)]
        [TestCase(1.0200000, false)]
        [TestCase(1.0200001, true)]
        public void IsInFuture_Stamp_IsTrueIfAheadByMoreThanBoundPlusOneSecond(double aheadSeconds, bool expected)
        {
            var stamp = Now + new TimeSpan((long)Math.Round(aheadSeconds * TimeSpan.TicksPerSecond));

            Assert.That(StampRule.IsInFuture(stamp, Now, Bound), Is.EqualTo(expected));
        }
    }
}
